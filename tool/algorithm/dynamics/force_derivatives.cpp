// Derivatives of inverse dynamics, one walk from each joint to the base (in the spirit of Singh, Russell and Wensing
// 2022), with velocities relative to each link's origin (moment_rates.h) in place of 6 x 6 matrices.
//
// The position of a joint moves all links beyond the joint like one rigid body. RelativeMotion in axes that move with
// this body, only the motion of the joint's parent changes: it rotates by the opposite angle. So the wrenches of the
// links beyond change by those of a change of their motion field (FieldChange, applied to the composite body), and the
// wrenches themselves rotate.
//
// A rotor (drives.h) with momentum m at unit rate adds the moment qdd m + w x qd m to the wrench of the link that
// carries it, and m . w' to the force of its joint. In axes that move with the body, w of a carrier beyond the moving
// joint changes by u, half of FieldChange::turning, and its w' by FieldChange::rate - w x u.
#include "algorithm/dynamics/force_derivatives.h"

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drive_derivatives.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/looped_derivatives.h"
#include "algorithm/dynamics/moment_rates.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// The change of accelerations per unit (rad or m) of a joint's position, in axes that move with its link. For one axis
// of a spherical joint, `motion` is that of the link with the whole joint at rest, because its axes move with the link.
FieldChange by_position(const Motion& S, const LinkMotion& motion) {
  const AngularState& angular = motion.angular;
  const Vector3 turning = cross(angular.w, S.angular);
  Motion rate{multiply_u(angular, S.angular), cross(motion.a, S.angular)};
  rate.linear += multiply_u(angular, S.linear);
  return {turning + turning, rate};
}

// Half of the change of accelerations per unit of a joint's velocity. For one axis of a spherical joint, w is the mean
// of the link's angular velocity and of that with the whole joint at rest: rates about the other axes count half.
FieldChange by_velocity(const Motion& S, const Vector3& w) {
  return change_of_field(w, S);
}

// The change of accelerations per unit of the base's angular velocity about one of its axes.
FieldChange by_base_turning(const Vector3& axis, const Motion& base_velocity) {
  return {axis + axis, {cross(base_velocity.angular, axis), cross(axis, base_velocity.linear)}};
}

// By link, in its axes: the momentum qd m of the rotors that it and all beyond it carry.
std::vector<Vector3> rotor_momenta(const TracedRobot& robot, const std::vector<Expression>& qd) {
  std::vector<Vector3> result;
  if (!robot.tree().has_rotors()) return result;
  result.resize(robot.tree().links.size());
  const std::vector<int> order = robot.tree().topological();
  for (int link = 0; link < static_cast<int>(result.size()); ++link)
    for (const TracedRotor& rotor : rotors_on(robot, link)) result[at(link)] += qd[at(rotor.joint)] * rotor.momentum;
  for (auto joint = order.rbegin(); joint != order.rend(); ++joint) {
    const model::Joint& j = robot.tree().joints[at(*joint)];
    if (!robot.parent_matters(j.child)) continue;
    result[at(j.parent)] += to_parent(robot.pose(*joint).rotation, result[at(j.child)]);
  }
  return result;
}

// Whether the next joint towards the base has its motion subspace in the same axes.
bool has_axes_of_child(const Joint& joint) {
  return joint.is_spherical() && joint.axis > 0;
}

using Row = std::vector<Expression>;

void set_base_rows(Row& column, const Force& wrench) {
  for (std::size_t k = 0; k < 3; ++k) {
    column[k] = wrench.moment[k];
    column[3 + k] = wrench.linear[k];
  }
}

class JointWalks {
 public:
  JointWalks(const TracedRobot& robot, const StateInputs& in, const Forces& forces)
      : robot_(robot),
        forces_(forces),
        bodies_(robot, in.qd, in.base_velocity.angular),
        rotor_momenta_(rotor_momenta(robot, in.qd)),
        in_(in),
        names_(joint_names(robot.tree())),
        base_(robot.floating() ? 6 : 0) {
    const std::size_t rows = names_.size(), joints = rows - at(base_);
    for (Columns* columns : {&result.q, &result.qd, &result.qdd}) columns->assign(joints, Row(rows));
    if (!robot.floating()) return;
    result.base_rotation.assign(3, Row(rows));
    result.base_velocity.assign(6, Row(rows));
    result.base_acceleration.assign(6, Row(rows));
  }

  ForceDerivatives result;

  // Fills the row and columns of a joint, up to the base.
  void fill_joint(int index, const Vector3& base_v) {
    Joint joint = robot_.joint(index);
    const std::size_t link = at(joint.child);
    const std::string& moving = robot_.tree().joints[at(index)].name;
    const std::string& name = robot_.link_name(joint.child);
    robot_.trace.section(name, "link " + name + ": derivatives of joint " + moving);
    const Motion S = subspace(joint, robot_.trace.graph);
    const MassProperties& body = bodies_.composite[link];
    const MomentRates& rates = bodies_.moment_rates[link];
    ChangeOfMotion row = row_of_joint(body, rates, joint, S);
    Walk walk{
        index, wrench_of(body, rates, by_velocity(S, mean_velocity(joint))),
        wrench_of(body, rates, by_position(S, felt_motion(joint)))};
    if (!rotor_momenta_.empty()) add_rotors_beyond(joint, S, walk, row);
    set_columns(walk, row, joint);
    bool is_in_own_axes = true;
    const RotorPath path = rotor_path(robot_.tree(), index);
    while (robot_.parent_matters(joint.child)) {
      if (is_in_own_axes && !has_axes_of_child(joint)) {
        walk.by_position += cross(S, forces_.wrenches[link]);
        is_in_own_axes = false;
      }
      describe_walk(walk, row, robot_.link_name(joint.child));
      const Pose& X_PC = robot_.pose(joint.index);
      walk.by_velocity = to_parent(X_PC, walk.by_velocity);
      walk.by_position = to_parent(X_PC, walk.by_position);
      row = to_parent(X_PC, bodies_.rates[at(joint.index)], row);
      if (path.end == robot_.tree().joints[at(joint.index)].parent) add_own_rotor(path, walk, row);
      const int parent = robot_.tree().parent_joint_of(joint.index);
      if (parent < 0) break;
      joint = robot_.joint(parent);
      set_columns(walk, row, joint);
      set_row(walk, row, joint);
    }
    if (robot_.floating()) fill_base_of_joint(walk, row, base_v);
  }

  // Adds the effect of the joint's rotor on the joints of its path, and the effect of their motion on it.
  void add_rotor_path(int index) {
    const RotorPath path = rotor_path(robot_.tree(), index);
    if (path.joints.empty()) return;
    const auto add = [](Columns& columns, int column, int row, const Expression& value) {
      columns[at(column)][at(row)] += value;
    };
    const Vector3 half = half_rate_of_rotor(path, index);
    ChangeOfMotion row{{rotor_momentum(robot_, index), {}}, half};
    for (const int passed : path.joints) {
      const Joint joint = robot_.joint(passed);
      const Motion S = subspace(joint, robot_.trace.graph);
      const Expression share = project(joint, row.Q), change = project(joint, Force{row.e, {}});
      add(result.qdd, index, base_ + passed, share);
      add(result.qd, index, base_ + passed, change + change);
      const Expression rate = dot(row, by_velocity(S, mean_velocity(joint)));
      add(result.qdd, passed, base_ + index, share);
      add(result.qd, passed, base_ + index, rate + rate);
      add(result.q, passed, base_ + index, dot(row, by_position(S, felt_motion(joint))));
      const Rotation& rotation = robot_.pose(passed).rotation;
      row = {{to_parent(rotation, row.Q.moment), {}}, to_parent(rotation, row.e)};
    }
  }

  // Fills the derivatives of the base wrench by the base's own motion.
  void fill_base(const Vector3& v) {
    robot_.trace.section(robot_.link_name(0), "base: derivatives");
    const MassProperties& body = bodies_.composite[0];
    for (std::size_t k = 0; k < 3; ++k) {
      Force wrench = wrench_of(body, bodies_.moment_rates[0], by_base_turning(unit(k), {bodies_.w[0], v}));
      if (!rotor_momenta_.empty()) wrench.moment += cross(unit(k), rotor_momenta_[0]);
      set_base_rows(result.base_velocity[k], wrench);
    }
    const SquareMatrix inertia = matrix(rigid_body_inertia(body));
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c) result.base_acceleration[at(c)][at(r)] = inertia(r, c);
  }

 private:
  // The change of the wrench on a link below a joint by the joint's own motion; by velocity, half of it.
  struct Walk {
    int joint;
    Force by_velocity, by_position;
  };

  const TracedRobot& robot_;
  const Forces& forces_;
  CompositeMotion bodies_;
  std::vector<Vector3> rotor_momenta_;  // by link: momentum of the rotors on it and beyond; empty without rotors
  const StateInputs& in_;
  Expression half_ = robot_.trace.graph.constant(0.5);
  std::vector<std::string> names_;  // of the rows of joints
  int base_;                        // number of rows of the base

  // The motion of a joint's link; for a spherical joint, the motion if that joint stood still.
  LinkMotion felt_motion(Joint joint) const {
    if (!joint.is_spherical()) return forces_.motions[at(joint.child)];
    joint = robot_.joint(joint.index - joint.axis);
    const int parent = robot_.tree().joints[at(joint.index)].parent;
    return carried_motion(robot_.pose(joint.index), forces_.motions[at(parent)]);
  }

  Vector3 mean_velocity(const Joint& joint) const {
    const Vector3& w = forces_.motions[at(joint.child)].angular.w;
    if (!joint.is_spherical()) return w;
    const std::size_t first = at(joint.index - joint.axis);
    return w - half_ * Vector3{in_.qd[first], in_.qd[first + 1], in_.qd[first + 2]};
  }

  Vector3 unit(std::size_t k) const { return unit_vector(robot_.trace.graph, k); }

  // Adds the rotors whose carriers are beyond the joint.
  void add_rotors_beyond(const Joint& joint, const Motion& S, Walk& walk, ChangeOfMotion& row) const {
    const Vector3 &p = rotor_momenta_[at(joint.child)], &s = S.angular;
    walk.by_velocity.moment += half_ * cross(s, p);
    walk.by_position.moment += cross(cross(felt_motion(joint).angular.w, s), p);
    row.e += half_ * cross(p, s);
  }

  // Half of the rate of a rotor's momentum, in the axes of its carrier.
  Vector3 half_rate_of_rotor(const RotorPath& path, int joint) const {
    return half_ * cross(bodies_.w[at(path.carrier)], rotor_momentum(robot_, joint));
  }

  // Adds the rotor of the walking joint, at the end of its path.
  void add_own_rotor(const RotorPath& path, Walk& walk, ChangeOfMotion& row) const {
    const Vector3 half = to_end(robot_, path, half_rate_of_rotor(path, walk.joint));
    walk.by_velocity.moment += half;
    row.Q.moment += to_end(robot_, path, rotor_momentum(robot_, walk.joint));
    row.e += half;
  }

  void set(Columns& columns, const char* by, int row, int column, const Expression& value) {
    columns[at(column)][at(base_ + row)] = value;
    described(coordinates("dtau", names_[at(base_ + row)], names_[at(base_ + column)], {}, by), value);
  }

  // Sets the derivatives of the force of a joint below, or of the walking joint's own force, by the motion of the
  // walking joint.
  void set_columns(const Walk& walk, const ChangeOfMotion& row, const Joint& below) {
    const Expression half = project(below, walk.by_velocity);
    set(result.qdd, "dqdd", below.index, walk.joint, project(below, row.Q));
    set(result.qd, "dqd", below.index, walk.joint, half + half);
    set(result.q, "dq", below.index, walk.joint, project(below, walk.by_position));
  }

  // Sets the derivatives of the walking joint's force by the motion of a joint below.
  void set_row(const Walk& walk, const ChangeOfMotion& row, const Joint& below) {
    const Motion S = subspace(below, robot_.trace.graph);
    const Expression half = dot(row, by_velocity(S, mean_velocity(below)));
    set(result.qdd, "dqdd", walk.joint, below.index, project(below, row.Q));
    set(result.qd, "dqd", walk.joint, below.index, half + half);
    set(result.q, "dq", walk.joint, below.index, dot(row, by_position(S, felt_motion(below))));
  }

  void fill_base_of_joint(const Walk& walk, const ChangeOfMotion& row, const Vector3& base_v) {
    const std::size_t j = at(walk.joint);
    set_base_rows(result.q[j], walk.by_position);
    set_base_rows(result.qd[j], walk.by_velocity);
    for (std::size_t k = 0; k < 6; ++k) result.qd[j][k] += result.qd[j][k];
    set_base_rows(result.qdd[j], row.Q);
    for (std::size_t k = 0; k < 3; ++k)
      result.base_velocity[k][at(base_) + j] = dot(row, by_base_turning(unit(k), {bodies_.w[0], base_v}));
    for (std::size_t k = 0; k < 6; ++k) result.base_acceleration[k][at(base_) + j] = result.qdd[j][k];
  }

  void describe_walk(const Walk& walk, const ChangeOfMotion& row, const std::string& link) const {
    const std::string& moving = robot_.tree().joints[at(walk.joint)].name;
    described(at_link(moving, link, "dq"), walk.by_position);
    described(at_link(moving, link, "dqd_half"), walk.by_velocity);
    described(at_link(moving, link), row.Q);
    described("e", at_link(moving, link), row.e);
  }
};

}  // namespace

ForceDerivatives force_derivatives(
    const TracedRobot& robot,
    const StateInputs& in,
    const Vector3& gravity,
    const Forces& forces,
    PassiveForces passive) {
  if (robot.tree().has_closures()) return looped_force_derivatives(robot, in, gravity, forces);
  JointWalks walks(robot, in, forces);
  for (int j = 0; j < static_cast<int>(robot.tree().joints.size()); ++j) walks.fill_joint(j, in.base_velocity.linear);
  for (int j = 0; j < static_cast<int>(robot.tree().joints.size()); ++j) walks.add_rotor_path(j);
  if (robot.floating()) {
    walks.fill_base(in.base_velocity.linear);
    fill_free_columns(gravity, in.base_velocity.angular, walks.result);
  }
  add_drives(robot.trace, in, walks.result, passive);
  return std::move(walks.result);
}

void fill_free_columns(const Vector3& gravity, const Vector3& base_w, ForceDerivatives& d) {
  const std::size_t rows = d.base_acceleration.front().size();
  d.base_rotation.resize(3, std::vector<Expression>(rows));
  d.base_velocity.resize(6, std::vector<Expression>(rows));
  for (std::size_t r = 0; r < rows; ++r) {
    Vector3 linear;
    for (std::size_t k = 0; k < 3; ++k) linear[k] = d.base_acceleration[3 + k][r];
    const Vector3 turn = cross(gravity, linear), slide = cross(linear, base_w);
    for (std::size_t k = 0; k < 3; ++k) {
      d.base_rotation[k][r] = turn[k];
      d.base_velocity[3 + k][r] = slide[k];
    }
  }
}

void fill_free_fall(Trace& trace, const Vector3& base_w, const Vector3& gravity, ForceDerivatives& d) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 axis = unit_vector(trace.graph, k);
    const Vector3 by_turn = cross(gravity, axis), by_velocity = cross(axis, base_w);
    std::vector<Expression>&turn = d.base_rotation[k], &slide = d.base_velocity[3 + k];
    turn.assign(turn.size(), {});
    slide.assign(slide.size(), {});
    for (std::size_t i = 0; i < 3; ++i) {
      turn[3 + i] = by_turn[i];
      slide[3 + i] = by_velocity[i];
    }
  }
}

void trace_inverse_dynamics_derivatives(Trace& trace, Loads loads, const Formulation& formulation) {
  const model::KinematicTree& tree = trace.tree;
  const StateInputs in = motion_inputs(trace);
  const TracedMotion motion(trace, in, loads, formulation);
  const Forces& forces = motion.forces;
  const ForceDerivatives d = force_derivatives(motion.robot, in, motion.load.gravity, forces);
  const int n = tree.dof(), rows = n + (tree.floating_base ? 6 : 0);
  trace.output("tau", Role::joint_force, by_coordinate(trace, forces.tau));
  if (tree.floating_base) trace.output("base_wrench", Role::base_wrench, forces.base_wrench);
  trace.output("d_q", Role::matrix, rows, d.q);
  trace.output("d_qd", Role::matrix, rows, d.qd);
  trace.output("d_qdd", tree.floating_base ? Role::matrix : Role::inertia_matrix, rows, d.qdd);
  if (tree.floating_base) {
    trace.output("d_base_rotation", Role::matrix, rows, d.base_rotation);
    trace.output("d_base_velocity", Role::matrix, rows, d.base_velocity);
    trace.output("d_base_acceleration", Role::matrix, rows, d.base_acceleration);
  }
}

Program inverse_dynamics_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  trace_inverse_dynamics_derivatives(trace, loads, formulation);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
