#include "algorithm/spatial/trace.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "algorithm/spatial/named.h"
#include "support/concat.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm {

using model::Quantity;
using symbolic::Role;

namespace {

const std::vector<std::string> kAxes = {"x", "y", "z"};

std::vector<std::string> spatial_elements() {
  std::vector<std::string> names;
  for (const char* part : {"w", "v"})
    for (const std::string& axis : kAxes) names.push_back(part + axis);
  return names;
}

// The elements of q with these labels; elements of quaternions belong to their joints.
std::vector<symbolic::QuantityRef> position_quantities(
    const model::KinematicTree& tree,
    const std::vector<std::string>& labels) {
  std::vector<symbolic::Quantity> elements;
  for (const std::string& label : labels) {
    symbolic::Quantity& element = elements.emplace_back(symbolic::Quantity{label, "q"});
    element.of_coordinates = true;
  }
  const std::vector<int> places = tree.position_elements();
  for (const int first : tree.spherical_joints())
    for (std::size_t i = 0; i < 4; ++i)
      elements[at(places[at(first)]) - 1 + i] = {tree.joints[at(first)].declared_name(), std::string(1, "wxyz"[i])};
  std::vector<symbolic::QuantityRef> result;
  for (symbolic::Quantity& element : elements)
    result.push_back(std::make_shared<const symbolic::Quantity>(std::move(element)));
  return result;
}

}  // namespace

Trace::Trace(const model::KinematicTree& robot) : tree(robot) {
  parameter_input(tree.parameters);
}

std::vector<double> parameter_values(const model::KinematicTree& tree) {
  std::vector<double> values;
  for (const model::Parameter& p : tree.parameters) {
    const double number = static_cast<double>(values.size());
    values.push_back(p.default_value.value_or(1.0 + 0.5 / (2.0 + number)));
  }
  return values;
}

void ProgramTrace::parameter_input(const std::vector<model::Parameter>& parameters) {
  if (parameters.empty()) return;
  std::vector<std::string> names;
  for (const model::Parameter& p : parameters) names.push_back(p.name);
  parameters_ = input("parameters", Role::parameters, std::move(names));
}

std::vector<Expression> ProgramTrace::input(const std::string& name, Role role, std::vector<std::string> elements) {
  std::vector<Expression> values;
  for (std::size_t i = 0; i < elements.size(); ++i) values.push_back(graph.input(input_elements_++));
  inputs_.push_back({name, role, std::move(elements)});
  return values;
}

std::vector<Expression> ProgramTrace::quantity_input(
    const std::string& name,
    Role role,
    const std::vector<symbolic::QuantityRef>& elements) {
  std::vector<std::string> labels;
  for (const symbolic::QuantityRef& element : elements) labels.push_back(text(*element));
  const std::vector<Expression> values = input(name, role, std::move(labels));
  inputs_.back().quantities = elements;
  return values;
}

std::vector<Expression> Trace::coordinate_input(const std::string& name, Role role) {
  std::vector<std::string> names;
  for (const int joint : tree.coordinates()) names.push_back(tree.joints[at(joint)].name);
  return input(name, role, std::move(names));
}

std::vector<Expression> Trace::position_input(const std::string& name, Role role) {
  const std::vector<int> elements = tree.position_elements();
  std::vector<int> quaternions;
  for (const int first : tree.spherical_joints()) quaternions.push_back(elements[at(first)] - 1);
  const std::vector<Expression> given = input(name, role, model::position_names(tree));
  inputs_.back().quaternions = quaternions;
  if (!quaternions.empty()) inputs_.back().quantities = position_quantities(tree, inputs_.back().elements);
  inputs_.back().followers = static_cast<int>(tree.followers_in_q().size());
  std::vector<Expression> positions;
  for (const int joint : tree.coordinates()) positions.push_back(given[at(elements[at(joint)])]);
  for (const int scalar : quaternions) positions.push_back(given[at(scalar)]);
  for (const int joint : tree.followers_in_q()) positions.push_back(given[at(elements[at(joint)])]);
  return positions;
}

std::vector<Expression> Trace::joint_input(const std::string& name, Role role) {
  if (role != Role::joint_position && role != Role::joint_reference)
    return by_joint(name, role, coordinate_input(name, role));
  return by_joint(name, Role::joint_position, position_input(name, role));
}

std::vector<Expression> Trace::by_joint(
    const std::string& name,
    Role role,
    const std::vector<Expression>& coordinates) {
  if (tree.couplings.empty()) return coordinates;
  std::vector<Expression> joints(tree.joints.size());
  const std::vector<int> independent = tree.coordinates();
  for (std::size_t k = 0; k < independent.size(); ++k) joints[at(independent[k])] = coordinates[k];
  const std::vector<int> dependents = role == Role::joint_position ? tree.followers_in_q() : std::vector<int>();
  const auto behind = coordinates.begin() + static_cast<std::ptrdiff_t>(independent.size());
  const auto first_dependent = coordinates.end() - static_cast<std::ptrdiff_t>(dependents.size());
  joints.insert(joints.end(), behind, first_dependent);
  for (std::size_t k = 0; k < dependents.size(); ++k)
    joints[at(dependents[k])] = first_dependent[static_cast<std::ptrdiff_t>(k)];
  for (const model::Coupling& coupling : tree.couplings) {
    if (!coupling.is_linear()) continue;
    const std::string& dependent = tree.joints[at(coupling.joint)].name;
    section(dependent, "joint " + dependent + ": " + name);
    Expression& value = joints[at(coupling.joint)];
    for (const model::Coupling::Term& term : coupling.terms) value += lift(term.factor) * joints[at(term.joint)];
    if (role == Role::joint_position) value += lift(coupling.offset);
    described(coordinate(name, dependent), value);
  }
  if (role == Role::joint_position) closures_.clear(), rates_.clear();
  for (std::size_t k = 0; k < tree.closures.size(); ++k) follow(k, role, joints);
  if (role == Role::joint_position) positions_ = joints;
  if (role == Role::joint_velocity) velocities_ = joints;
  return joints;
}

std::vector<Expression> Trace::positions(const std::vector<Expression>& joints) const {
  const std::vector<int> elements = tree.position_elements(), spherical = tree.spherical_joints();
  std::vector<Expression> q(at(tree.position_count()));
  for (std::size_t j = 0; j < tree.joints.size(); ++j)
    if (elements[j] >= 0) q[at(elements[j])] = joints[j];
  for (std::size_t k = 0; k < spherical.size(); ++k)
    q[at(elements[at(spherical[k])] - 1)] = joints[tree.joints.size() + k];
  return q;
}

void Trace::follow(std::size_t index, Role role, std::vector<Expression>& joints) {
  const model::Closure& closure = tree.closures[index];
  if (role == Role::joint_position) {
    closures_.push_back(traced(*this, closure, joints));
    return;
  }
  TracedClosure& solved = *closures_.at(index);
  const auto& rates = solved.rates();
  std::vector<Expression> added(closure.dependents.size());
  if (role == Role::joint_acceleration && !velocities_.empty()) added = solved.accelerations(velocities_);
  const std::string& loop = tree.loops[at(closure.loop())].name;
  section(loop, "loop ", ": motion of its joints");
  for (std::size_t d = 0; d < closure.dependents.size(); ++d) {
    Expression& value = joints[at(closure.dependents[d])];
    value = added[d];
    for (const RateTerm& share : rates[d]) value += share.factor * joints[at(share.joint)];
  }
}

std::vector<Expression> Trace::accelerations_at_rest() {
  if (tree.closures.empty()) return std::vector<Expression>(tree.joints.size());
  return by_joint("qdd", Role::joint_acceleration, std::vector<Expression>(at(tree.dof())));
}

// If formulas close a loop, the rates of its sines and cosines are given: nothing is differentiated beyond them.
std::vector<symbolic::Rate> Trace::motion_of_positions(const std::vector<Expression>& qd) {
  std::vector<symbolic::Rate> motion;
  for (std::size_t j = 0; j < tree.joints.size(); ++j) motion.push_back({positions_[j], qd[j]});
  for (const model::Closure& closure : tree.closures) {
    if (closure.method == model::Closure::Method::iterative) continue;
    for (const int joint : closure.dependents) {
      if (!model::turns(tree.joints[at(joint)].type)) continue;
      const Expression sine = sin(positions_[at(joint)]), cosine = cos(positions_[at(joint)]);
      motion.push_back({sine, cosine * qd[at(joint)]});
      motion.push_back({cosine, -(sine * qd[at(joint)])});
    }
  }
  return motion;
}

std::vector<Expression> Trace::added_by_loops(const std::vector<Expression>& qd, const std::vector<Expression>& v) {
  std::vector<Expression> added(tree.joints.size());
  if (tree.closures.empty()) return added;
  const std::vector<symbolic::Rate> motion = motion_of_positions(qd);
  for (std::size_t k = 0; k < tree.closures.size(); ++k) {
    const std::vector<Expression> changes = closures_.at(k)->changes(motion, v);
    const auto& rates = closures_[k]->rates();
    for (std::size_t d = 0; d < changes.size(); ++d) {
      Expression& value = added[at(tree.closures[k].dependents[d])];
      value = changes[d];
      for (const RateTerm& share : rates[d]) value += share.factor * added[at(share.joint)];
    }
  }
  return added;
}

std::vector<Expression> Trace::reference_acceleration_input(
    const std::string& name,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& v) {
  velocities_.clear();  // `v` replaces them
  std::vector<Expression> rates = joint_input(name, Role::joint_acceleration);
  const std::vector<Expression> added = added_by_loops(qd, v);
  for (std::size_t j = 0; j < added.size(); ++j) rates[j] += added[j];
  return rates;
}

const std::vector<RateTerm>& Trace::rates_of(const model::Coupling& coupling) {
  if (rates_.empty()) rates_.resize(tree.joints.size());
  std::vector<RateTerm>& known = rates_[at(coupling.joint)];
  if (!known.empty()) return known;
  const model::Closure& closure = tree.closures[at(coupling.closure)];
  const auto place = std::find(closure.dependents.begin(), closure.dependents.end(), coupling.joint);
  const auto d = static_cast<std::size_t>(place - closure.dependents.begin());
  std::map<int, Expression> sums;
  for (const RateTerm& share : closures_.at(at(coupling.closure))->rates()[d]) {
    const model::Coupling* given = tree.coupling_of(share.joint);
    if (given == nullptr) {
      sums[share.joint] += share.factor;
    } else if (given->is_linear()) {
      for (const model::Coupling::Term& term : given->terms) sums[term.joint] += share.factor * lift(term.factor);
    } else {
      for (const RateTerm& beyond : rates_of(*given)) sums[beyond.joint] += share.factor * beyond.factor;
    }
  }
  for (const auto& [joint, factor] : sums) known.push_back({joint, factor});
  return known;
}

std::vector<std::vector<Expression>> Trace::reactions(
    const std::vector<Expression>& q,
    std::vector<Expression> forces) {
  std::vector<std::vector<Expression>> result(tree.loops.size());
  const auto add = [&](const model::Closure& closure, TracedClosure& closed) {
    const std::vector<std::vector<Expression>> of_closure = closed.reaction(forces);
    for (std::size_t k = 0; k < of_closure.size(); ++k) result[at(closure.loops[k])] = of_closure[k];
  };
  // From last to first: loops that take joints of others as given come after these.
  for (std::size_t k = closures_.size(); k-- > 0;) add(tree.closures[k], *closures_[k]);
  for (std::size_t k = tree.parallelograms.size(); k-- > 0;)
    add(tree.parallelograms[k], *traced_open(*this, tree.parallelograms[k], q));
  return result;
}

std::vector<Expression> Trace::base_pose_input() {
  std::vector<Expression> pose = input("base_pose", Role::base_pose, {"qw", "qx", "qy", "qz", "px", "py", "pz"});
  inputs_.back().quaternions = {0};
  return pose;
}

Vector3 Trace::vector_input(const std::string& name, Role role) {
  const std::vector<Expression> v = input(name, role, kAxes);
  return {v[0], v[1], v[2]};
}

Motion Trace::motion_input(const std::string& name, Role role) {
  const std::vector<Expression> v = input(name, role, spatial_elements());
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

std::vector<Force> Trace::link_wrench_input() {
  std::vector<symbolic::QuantityRef> elements;
  for (const model::Link& link : tree.links) {
    if (link.is_repeated) continue;
    for (const char* part : {"n", "f"})
      for (const std::string& axis : kAxes)
        elements.push_back(std::make_shared<const symbolic::Quantity>(symbolic::Quantity{link.name, part, axis}));
  }
  const std::vector<Expression> v = quantity_input("external", Role::link_wrenches, elements);
  std::vector<Force> wrenches(tree.links.size());
  std::size_t i = 0;
  for (std::size_t link = 0; link < wrenches.size(); ++link) {
    if (tree.links[link].is_repeated) continue;
    wrenches[link] = {Vector3{v[i], v[i + 1], v[i + 2]}, Vector3{v[i + 3], v[i + 4], v[i + 5]}};
    i += 6;
  }
  return wrenches;
}

void ProgramTrace::output(const std::string& name, Role role, const std::vector<Expression>& values) {
  output(name, role, static_cast<int>(values.size()), 1, values);
}

void ProgramTrace::output(const std::string& name, Role role, const Motion& value) {
  const Vector3 &w = value.angular, &v = value.linear;
  output(name, role, std::vector<Expression>{w[0], w[1], w[2], v[0], v[1], v[2]});
}

void ProgramTrace::output(const std::string& name, Role role, const Force& value) {
  const Vector3 &n = value.moment, &f = value.linear;
  output(name, role, std::vector<Expression>{n[0], n[1], n[2], f[0], f[1], f[2]});
}

void ProgramTrace::output(
    const std::string& name,
    Role role,
    int rows,
    int columns,
    const std::vector<Expression>& values) {
  shapes_.push_back({name, role, rows, columns, {}});
  outputs_.push_back(values);
}

void ProgramTrace::output(const std::string& name, Role role, int rows, const Columns& columns) {
  std::vector<Expression> values;
  for (const std::vector<Expression>& column : columns) values.insert(values.end(), column.begin(), column.end());
  output(name, role, rows, static_cast<int>(columns.size()), values);
}

void ProgramTrace::section(const std::string& subject, const std::string& title) {
  if (graph.keeps_names()) graph.begin_section(title, subject);
}

void ProgramTrace::section(const std::string& subject, const char* before, const char* after) {
  if (graph.keeps_names()) graph.begin_section(before + subject + after, subject);
}

void ProgramTrace::section(const std::string& subject, std::initializer_list<std::string_view> title) {
  if (graph.keeps_names()) graph.begin_section(concat(title), subject);
}

Expression ProgramTrace::lift(const Quantity& q, const std::vector<Expression>& variables) {
  switch (q.op()) {
    case Quantity::Op::constant:
      return graph.constant(q.number());
    case Quantity::Op::parameter:
      return parameters_[static_cast<std::size_t>(q.index())];
    case Quantity::Op::variable:
      return variables.at(static_cast<std::size_t>(q.index()));
    default:
      break;
  }
  const Expression left = lift(q.left(), variables);
  const auto right = [&] { return lift(q.right(), variables); };
  switch (q.op()) {
    case Quantity::Op::negate:
      return -left;
    case Quantity::Op::add:
      return left + right();
    case Quantity::Op::subtract:
      return left - right();
    case Quantity::Op::multiply:
      return left * right();
    case Quantity::Op::divide:
      return left / right();
    case Quantity::Op::sine:
      return sin(left);
    case Quantity::Op::cosine:
      return cos(left);
    case Quantity::Op::tangent: {
      const Expression sine = sin(left);
      return sine / cos(left);
    }
    case Quantity::Op::square_root:
      return sqrt(left);
    default:
      break;
  }
  throw std::logic_error("unknown quantity");
}

Vector3 ProgramTrace::lift(const std::array<Quantity, 3>& q, const std::vector<Expression>& variables) {
  return {lift(q[0], variables), lift(q[1], variables), lift(q[2], variables)};
}

symbolic::Program ProgramTrace::program(const std::string& name) const {
  return graph.program(name, inputs_, shapes_, outputs_);
}

symbolic::TracedCost ProgramTrace::cost() const {
  symbolic::TracedCost cost = symbolic::traced_cost(graph, outputs_);
  if (!parameters_.empty()) cost.work = symbolic::work(program(""));
  return cost;
}

}  // namespace robcogen::algorithm
