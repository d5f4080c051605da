#include "algorithm/identification/drive_regressor.h"

#include "algorithm/dynamics/drives.h"
#include "algorithm/identification/reference_motion.h"
#include "algorithm/identification/regressor.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// The joints whose rotors are on links that move.
std::vector<int> moving_rotors(const model::KinematicTree& tree) {
  std::vector<int> joints;
  for (const int j : model::independent_joints_first(tree)) {
    const std::optional<model::Rotor>& rotor = tree.joints[at(j)].drive.rotor;
    if (rotor && rotor->carrier >= first_moving_link(tree)) joints.push_back(j);
  }
  return joints;
}

// Columns of rotors: a rotor of unit momentum turns with its carrier and, at the rate of its joint, about its axis a;
// that takes a moment qdd a + qd w x a on the carrier, and a . wd at the joint.
class RotorColumns {
 public:
  RotorColumns(const TracedRobot& robot, const StateInputs& in, int rows)
      : robot_(robot),
        in_(in),
        rotors_(moving_rotors(robot.tree())),
        columns_(rotors_.size(), RegressorColumn(at(rows))) {
    for (std::size_t j = 0; j < in.qd.size(); ++j) rates_.push_back({in.qd[j], in.qd[j], in.qdd[j]});
  }

  std::vector<RegressorColumn> of_base(const Motion& velocity, const Motion& acceleration) {
    if (rotors_.empty()) return {};
    std::vector<UnitTurn> units;
    for (int k = 0; robot_.floating() && k < 3; ++k) {
      Vector3 axis;
      axis[at(k)] = robot_.trace.graph.one();
      units.push_back({k, axis});
    }
    visit(0, base_motion(velocity, velocity, acceleration, {}), units);
    return std::move(columns_);
  }

 private:
  // The angular velocity of a link per unit of a row's motion.
  struct UnitTurn {
    int row;
    Vector3 axis;
  };

  const TracedRobot& robot_;
  const StateInputs& in_;
  std::vector<int> rotors_;
  std::vector<RegressorColumn> columns_;
  std::vector<ReferenceRate> rates_;

  int row_of(int joint) const { return joint + (robot_.floating() ? 6 : 0); }

  Vector3 axis_of(int joint) const {
    const model::Joint& of_model = robot_.tree().joints[at(joint)];
    if (of_model.drive.rotor->axis) return robot_.trace.lift(model::rotor_axis(of_model));
    return to_parent(robot_.pose(joint).rotation, {Expression(), Expression(), robot_.trace.graph.one()});
  }

  void visit(int link, const ReferenceMotion& motion, const std::vector<UnitTurn>& units) {
    for (std::size_t k = 0; k < rotors_.size(); ++k) {
      const int joint = rotors_[k];
      if (robot_.tree().joints[at(joint)].drive.rotor->carrier != link) continue;
      robot_.trace.section(robot_.link_name(link), "link ", ": rotor");
      const Vector3 axis = axis_of(joint);
      Vector3 moment = in_.qdd[at(joint)] * axis;
      moment += cross(motion.w, in_.qd[at(joint)] * axis);
      for (const UnitTurn& unit : units) columns_[k][at(unit.row)] += dot(unit.axis, moment);
      columns_[k][at(row_of(joint))] += dot(axis, motion.rd);
    }
    for (const Joint& joint : robot_.children(link)) {
      const Pose& X_PC = robot_.pose(joint.index);
      Graph& graph = robot_.trace.graph;
      robot_.trace.section(robot_.link_name(joint.child), "link ", ": motion");
      std::vector<UnitTurn> carried;
      for (const UnitTurn& unit : units) carried.push_back({unit.row, to_child(X_PC.rotation, unit.axis)});
      carried.push_back({row_of(joint.index), subspace(joint, graph).angular});
      visit(joint.child, across_joint(graph, joint, X_PC, motion, rates_), carried);
    }
  }
};

}  // namespace

std::vector<std::string> drive_parameter_names(const model::KinematicTree& tree) {
  std::vector<std::string> names;
  for (const int j : model::independent_joints_first(tree))
    for (const char* parameter : {"inertia", "damping", "friction", "stiffness", "force"})
      names.push_back(tree.joints[at(j)].name + "_" + parameter);
  for (const model::Tendon& tendon : tree.tendons)
    for (const char* parameter : {"stiffness", "damping", "force"}) names.push_back(tendon.name + "_" + parameter);
  for (const int j : moving_rotors(tree)) names.push_back(tree.joints[at(j)].name + "_rotor");
  return names;
}

Program drive_parameters(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  std::vector<Expression> numbers;
  for (const int j : model::independent_joints_first(tree)) {
    const model::Joint& joint = tree.joints[at(j)];
    trace.section(joint.name, "joint ", ": parameters of its drive");
    numbers.push_back(drive_inertia(trace, j));
    for (const model::Quantity* q : {&joint.drive.damping, &joint.drive.friction, &joint.drive.stiffness})
      numbers.push_back(trace.lift(*q));
    numbers.push_back(-trace.lift(joint.drive.stiffness * joint.drive.rest));
  }
  for (const model::Tendon& tendon : tree.tendons) {
    trace.section(tendon.name, "tendon ", ": parameters");
    numbers.push_back(trace.lift(tendon.stiffness));
    numbers.push_back(trace.lift(tendon.damping));
    numbers.push_back(-trace.lift(tendon.stiffness * tendon.rest));
  }
  for (const int j : moving_rotors(tree)) {
    const model::Rotor& rotor = *tree.joints[at(j)].drive.rotor;
    numbers.push_back(trace.lift(rotor.inertia * rotor.ratio));
  }
  trace.output("pi", Role::value, numbers);
  return trace.program(name);
}

Program drive_regressor(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const StateInputs in = motion_inputs(trace);
  const TracedRobot robot(trace, in.q);
  const int first = tree.floating_base ? 6 : 0, rows = first + static_cast<int>(tree.joints.size());
  std::vector<RegressorColumn> columns;
  for (const int j : model::independent_joints_first(tree)) {
    const model::Joint& joint = tree.joints[at(j)];
    trace.section(joint.name, "joint ", ": columns of its drive");
    const Expression sign = described("sign", joint.name, smooth_sign(trace, joint.drive, in.qd[at(j)]));
    const Expression position = joint.spherical.empty() ? in.q[at(j)] : Expression();
    for (const Expression& element : {in.qdd[at(j)], in.qd[at(j)], sign, position, trace.graph.one()}) {
      columns.emplace_back(at(rows));
      columns.back()[at(first + j)] = element;
    }
  }
  for (model::Tendon tendon : tree.tendons) {
    trace.section(tendon.name, "tendon ", ": columns");
    tendon.rest = model::Quantity();
    const TendonMotion motion = tendon_motion(trace, tendon, in.q, in.qd);
    for (const Expression& element : {motion.stretch, motion.rate, trace.graph.one()}) {
      columns.emplace_back(at(rows));
      for (const model::Tendon::Term& term : tendon.terms)
        columns.back()[at(first + term.joint)] = trace.lift(term.factor) * element;
    }
  }
  for (RegressorColumn& column : RotorColumns(robot, in, rows).of_base(in.base_velocity, in.base_acceleration))
    columns.push_back(std::move(column));
  const int size = static_cast<int>(columns.size());
  trace.output("Y", Role::matrix, first + tree.dof(), size, flat_by_coordinate(trace, columns));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
