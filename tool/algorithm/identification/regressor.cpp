// The wrench of a link is linear in its inertial parameters, and a joint below feels its power along the motion that
// the joint gives the link. So the unit motions of joints are passed down to each link, two vectors per pair of joint
// and link, instead of ten wrenches up.
//
// Matter that does not move with its joint could as well belong to the parent: if that costs less, its column is
// computed from columns of the parent.
#include "algorithm/identification/regressor.h"

#include "algorithm/identification/reference_motion.h"
#include "algorithm/kinematics/joint_poses.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// The order of the inertial parameters of a link.
struct Place {
  enum : std::size_t { m, hx, hy, hz, Ixx, Iyy, Izz, Ixy, Ixz, Iyz };
};

using Entries = std::array<Expression, kParametersOfLink>;

// The power along a unit motion of a link of the wrench that each of its inertial parameters takes.
class EntriesOfLink {
 public:
  EntriesOfLink(const VelocityChange& change, Moments moments) : change_(change), moments_(moments) {}

  Expression operator()(std::size_t parameter, const Motion& unit) const {
    const Vector3 &s = unit.angular, &v = unit.linear;
    switch (parameter) {
      case Place::m:
        return dot(v, change_.a());
      case Place::hx:
      case Place::hy:
      case Place::hz:
        return of_first_moment(parameter - Place::hx, s, v);
      case Place::Ixx:
      case Place::Iyy:
      case Place::Izz:
        return moments_ == Moments::of_inertia ? of_moment(parameter - Place::Ixx, s)
                                               : of_second_moment(parameter - Place::Ixx, s);
      case Place::Ixy:
        return of_product(0, 1, s);
      case Place::Ixz:
        return of_product(2, 0, s);
      default:
        return of_product(1, 2, s);
    }
  }

 private:
  const VelocityChange& change_;
  Moments moments_;

  // f = U e, n = e x a.
  Expression of_first_moment(std::size_t i, const Vector3& s, const Vector3& v) const {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    Expression result = difference_of_products(change_.a()[j], s[k], change_.a()[k], s[j]);
    for (std::size_t r = 0; r < 3; ++r)
      if (!v[r].is_zero()) result += change_.u(r, i) * v[r];
    return result;
  }

  // About i the axial vector, about the others products; the latter are shared by the three moments.
  Expression of_moment(std::size_t i, const Vector3& s) const {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Expression turning = s[i] * change_.axis()[i];
    const Expression sideways = difference_of_products(s[j], change_.product(i, k), s[k], change_.product(i, j));
    return turning + sideways;
  }

  // f = 0, n = e x U e.
  Expression of_second_moment(std::size_t i, const Vector3& s) const {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    Expression result;
    if (!s[k].is_zero()) result += s[k] * change_.u(j, i);
    return s[j].is_zero() ? result : result - s[j] * change_.u(k, i);
  }

  // The entry of the product of inertia of axes i and j, where j follows i.
  Expression of_product(std::size_t i, std::size_t j, const Vector3& s) const {
    const std::size_t k = 3 - i - j;
    Expression result;
    if (!s[i].is_zero()) result += s[i] * change_.u(k, i);
    if (!s[j].is_zero()) result -= s[j] * change_.u(k, j);
    return s[k].is_zero() ? result : result + s[k] * change_.difference(j, i);
  }
};

// ---- Parameters that could belong to the parent.

// Sums of inertial parameters of the child whose matter does not move with the joint, but with the parent: a rod on the
// axis of a revolute joint, a point at the centre of a spherical one, or all inertia of a link that only slides. The
// last one of a sum follows from the others.
std::vector<std::vector<std::size_t>> carried_by_parent(model::JointType type, Moments moments) {
  switch (type) {
    case model::JointType::revolute:
      if (moments == Moments::of_mass) return {{Place::m}, {Place::hz}, {Place::Izz}};
      return {{Place::m}, {Place::hz}, {Place::Ixx, Place::Iyy}};
    case model::JointType::prismatic:
      return {{Place::Ixx}, {Place::Iyy}, {Place::Izz}, {Place::Ixy}, {Place::Ixz}, {Place::Iyz}};
    case model::JointType::helical:
      if (moments == Moments::of_mass) return {{Place::Izz}};
      return {{Place::Ixx, Place::Iyy}};
    case model::JointType::spherical:
      return {{Place::m}};
  }
  return {};
}

// Such a sum, as inertial parameters of the parent.
struct Transfer {
  std::vector<std::size_t> of_child;
  InertialNumbers of_parent;
};

// ---- The walk.

class RegressorBuilder {
 public:
  RegressorBuilder(const TracedRobot& robot, const RepresentativeLinks& representative, Moments moments)
      : robot_(robot),
        base_rows_(robot.floating() ? 6 : 0),
        rows_(base_rows_ + static_cast<int>(robot.tree().joints.size())),
        columns(robot.tree().links.size()),
        moments_(moments),
        names_(inertial_parameter_names(robot.tree())) {
    at_rest_ = poses_at_rest(robot.trace);
    for (std::size_t j = 0; j < representative.size(); ++j) fold_like(robot.trace, representative[j], at_rest_[j]);
  }

  void visit_base(const ReferenceMotion& motion, const std::vector<ReferenceRate>& rates) {
    std::vector<UnitMotion> units;
    for (int k = 0; k < base_rows_; ++k) {
      Motion unit;
      (k < 3 ? unit.angular : unit.linear)[at(k % 3)] = robot_.trace.graph.one();
      units.push_back({k, unit});
    }
    visit(0, motion, units, rates);
  }

 private:
  // The unit motion of the joint or of the base that a row belongs to.
  struct UnitMotion {
    int row;
    Motion motion;
  };

  const TracedRobot& robot_;
  int base_rows_, rows_;
  std::vector<Pose> at_rest_;  // by joint

 public:
  std::vector<LinkColumns> columns;  // by link

 private:
  Moments moments_;
  std::vector<std::string> names_;

  void visit(
      int link,
      const ReferenceMotion& motion,
      const std::vector<UnitMotion>& units,
      const std::vector<ReferenceRate>& rates) {
    if (!units.empty() && !robot_.tree().links[at(link)].is_repeated) fill(link, motion, units);
    Trace& trace = robot_.trace;
    for (const Joint& joint : robot_.children(link)) {
      const Pose& X_PC = robot_.pose(joint.index);
      const std::string& name = robot_.link_name(joint.child);
      trace.section(name, "link ", ": motion");
      const ReferenceMotion child = named(name, across_joint(trace.graph, joint, X_PC, motion, rates));
      std::vector<UnitMotion> carried;
      for (const UnitMotion& unit : units) {
        carried.push_back({unit.row, described(at_link(row_name(unit.row), name), to_child(X_PC, unit.motion))});
      }
      carried.push_back({base_rows_ + joint.index, subspace(joint, trace.graph)});
      visit(joint.child, child, carried, rates);
    }
  }

  std::string row_name(int row) const {
    if (row < base_rows_) return std::string("base_") + "nf"[row / 3] + "xyz"[row % 3];
    return robot_.tree().joints[at(row - base_rows_)].name;
  }

  void fill(int link, const ReferenceMotion& motion, const std::vector<UnitMotion>& units) {
    const std::string& name = robot_.link_name(link);
    robot_.trace.section(name, "link ", ": columns of its inertial parameters");
    const VelocityChange change(motion);
    describe(change, name);
    const EntriesOfLink entries(change, moments_);
    const std::vector<Transfer> transfers = transfers_of(link);
    const std::size_t first = at(kParametersOfLink * (link - first_moving_link(robot_.tree())));
    LinkColumns& own = columns[at(link)];
    own.fill(RegressorColumn(at(rows_)));
    // The rows of the link's own joint are as short as can be, and the parent has no such rows.
    const std::size_t own_rows = robot_.is_base(link) ? 0 : robot_.parent_joint(link).is_spherical() ? 3 : 1;
    for (const UnitMotion& unit : units) {
      const bool is_own = &unit >= units.data() + units.size() - own_rows;
      const Entries row = is_own || robot_.is_base(link) ? all(entries, unit.motion)
                                                         : cheapest(entries, unit, parent_of(link), transfers);
      for (std::size_t p = 0; p < row.size(); ++p) {
        own[p][at(unit.row)] = described(coordinates("Y", row_name(unit.row), names_[first + p]), row[p]);
      }
    }
  }

  // The joint that carries a link; for a spherical joint its first component.
  int joint_below(int link) const {
    return robot_.tree().first_component_of(robot_.tree().links[at(link)].parent_joint);
  }
  int parent_of(int link) const { return robot_.tree().joints[at(joint_below(link))].parent; }

  static Entries all(const EntriesOfLink& entries, const Motion& unit) {
    Entries row;
    for (std::size_t p = 0; p < row.size(); ++p) row[p] = entries(p, unit);
    return row;
  }

  std::vector<Transfer> transfers_of(int link) {
    if (robot_.is_base(link) || columns[at(parent_of(link))].front().empty()) return {};
    const Joint joint = robot_.parent_joint(link);
    std::vector<Transfer> transfers;
    for (std::vector<std::size_t>& sum : carried_by_parent(joint.type, moments_)) {
      InertialNumbers unit;
      for (const std::size_t p : sum) unit[p] = robot_.trace.graph.one();
      const InertialNumbers of_parent =
          inertial_numbers(to_parent(at_rest_[at(joint_below(link))], mass_properties(unit, moments_)), moments_);
      transfers.push_back({std::move(sum), of_parent});
    }
    return transfers;
  }

  Expression transferred(const Transfer& transfer, int parent, int row) const {
    Expression sum;
    for (std::size_t p = 0; p < transfer.of_parent.size(); ++p)
      if (!transfer.of_parent[p].is_zero()) sum += transfer.of_parent[p] * columns[at(parent)][p][at(row)];
    return sum;
  }

  template <class Make>
  int cost(const Make& make) const {
    Graph& graph = robot_.trace.graph;
    const std::size_t before = graph.mark();
    make();
    const int result = symbolic::work_since(graph, before);
    graph.rollback(before);
    return result;
  }

  Entries cheapest(
      const EntriesOfLink& entries,
      const UnitMotion& unit,
      int parent,
      const std::vector<Transfer>& transfers) const {
    std::array<const Transfer*, kParametersOfLink> by_transfer{};
    for (const Transfer& transfer : transfers) by_transfer[transfer.of_child.back()] = &transfer;
    Entries row;
    for (std::size_t p = 0; p < row.size(); ++p)
      if (by_transfer[p] == nullptr) row[p] = entries(p, unit.motion);
    for (std::size_t p = 0; p < row.size(); ++p) {
      if (by_transfer[p] == nullptr) continue;
      const auto direct = [&] { return entries(p, unit.motion); };
      const auto by_parent = [&] {
        const Transfer& transfer = *by_transfer[p];
        const Expression sum = transferred(transfer, parent, unit.row);
        return transfer.of_child.size() > 1 ? sum - row[transfer.of_child.front()] : sum;
      };
      row[p] = cost(by_parent) < cost(direct) ? by_parent() : direct();
    }
    return row;
  }
};

std::vector<ReferenceRate> rates_of(
    const std::vector<Expression>& qd,
    const std::vector<Expression>& reference,
    const std::vector<Expression>& acceleration) {
  std::vector<ReferenceRate> rates;
  for (std::size_t j = 0; j < qd.size(); ++j) rates.push_back({qd[j], reference[j], acceleration[j]});
  return rates;
}

std::vector<LinkColumns> columns_of(
    const TracedRobot& robot,
    const ReferenceMotion& base,
    const std::vector<ReferenceRate>& rates,
    const RepresentativeLinks& representative,
    Moments moments = Moments::of_inertia) {
  named(robot.link_name(0), base);
  RegressorBuilder builder(robot, representative, moments);
  builder.visit_base(base, rates);
  return std::move(builder.columns);
}

Program write_regressor(Trace& trace, const std::string& name, const std::vector<LinkColumns>& links) {
  std::vector<RegressorColumn> columns;
  for (int link = first_moving_link(trace.tree); link < trace.tree.link_count(); ++link)
    columns.insert(columns.end(), links[at(link)].begin(), links[at(link)].end());
  const int rows = trace.tree.dof() + (trace.tree.floating_base ? 6 : 0);
  trace.output("Y", Role::matrix, rows, static_cast<int>(columns.size()), flat_by_coordinate(trace, columns));
  return trace.program(name);
}

}  // namespace

std::vector<LinkColumns> regressor_columns(
    Trace& trace,
    Loads loads,
    const RepresentativeLinks& representative,
    Moments moments) {
  const StateInputs in = motion_inputs(trace);
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, representative);
  const ReferenceMotion base = base_motion(in.base_velocity, in.base_velocity, in.base_acceleration, load.gravity);
  return columns_of(robot, base, rates_of(in.qd, in.qd, in.qdd), representative, moments);
}

std::vector<Expression> flat_by_coordinate(Trace& trace, const std::vector<RegressorColumn>& columns) {
  const std::ptrdiff_t base = trace.tree.floating_base ? 6 : 0;
  std::vector<Expression> result;
  for (const RegressorColumn& column : columns) {
    result.insert(result.end(), column.begin(), column.begin() + base);
    const std::vector<Expression> joints = by_coordinate(trace, RegressorColumn(column.begin() + base, column.end()));
    result.insert(result.end(), joints.begin(), joints.end());
  }
  return result;
}

Program regressor(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative) {
  Trace trace(tree);
  return write_regressor(trace, name, regressor_columns(trace, loads, representative));
}

Program slotine_li_regressor(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity});
  const std::vector<Expression> qd_r = trace.joint_input("qd_r", Role::joint_velocity);
  const std::vector<Expression> qdd_r = trace.reference_acceleration_input("qdd_r", in.qd, qd_r);
  Motion velocity, reference, acceleration;
  if (tree.floating_base) {
    velocity = trace.motion_input("base_velocity", Role::base_velocity);
    reference = trace.motion_input("base_velocity_r", Role::base_velocity);
    acceleration = trace.motion_input("base_acceleration_r", Role::base_acceleration);
  }
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, representative);
  const ReferenceMotion base = base_motion(velocity, reference, acceleration, load.gravity);
  return write_regressor(trace, name, columns_of(robot, base, rates_of(in.qd, qd_r, qdd_r), representative));
}

}  // namespace robcogen::algorithm
