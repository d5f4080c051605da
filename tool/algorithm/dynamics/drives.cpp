#include "algorithm/dynamics/drives.h"

#include "algorithm/dynamics/dynamics.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {

Expression drive_inertia(Trace& trace, int joint) {
  const model::Drive& drive = trace.tree.joints[at(joint)].drive;
  if (!drive.rotor) return trace.lift(drive.armature);
  const auto& [inertia, ratio, axis, carrier] = *drive.rotor;
  return trace.lift(drive.armature + inertia * ratio * ratio);
}

RotorPath rotor_path(const model::KinematicTree& tree, int joint) {
  const model::Joint& turning = tree.joints[at(joint)];
  if (!turning.drive.rotor) return {};
  const auto carries_joint = [&](int link) {
    for (int l = turning.parent; l != link; l = tree.joints[at(tree.links[at(l)].parent_joint)].parent)
      if (tree.links[at(l)].parent_joint < 0) return false;
    return true;
  };
  RotorPath path{turning.drive.rotor->carrier, {}, turning.drive.rotor->carrier};
  while (!carries_joint(path.end)) {
    path.joints.push_back(tree.links[at(path.end)].parent_joint);
    path.end = tree.joints[at(path.joints.back())].parent;
  }
  return path;
}

Vector3 to_end(const TracedRobot& robot, const RotorPath& path, Vector3 v) {
  for (const int joint : path.joints) v = to_parent(robot.pose(joint).rotation, v);
  return v;
}

Vector3 rotor_momentum(const TracedRobot& robot, int joint, int link) {
  const RotorPath path = rotor_path(robot.tree(), joint);
  return path.end == link ? to_end(robot, path, rotor_momentum(robot, joint)) : Vector3();
}

Vector3 rotor_momentum(const TracedRobot& robot, int joint) {
  const model::Joint& of_model = robot.tree().joints[at(joint)];
  const std::optional<model::Rotor>& rotor = of_model.drive.rotor;
  if (!rotor) return {};
  const Expression size = robot.trace.lift(rotor->inertia * rotor->ratio);
  if (!rotor->axis) return to_parent(robot.pose(joint).rotation, {Expression(), Expression(), size});
  const Vector3 momentum = size * robot.trace.lift(model::rotor_axis(of_model));
  return robot.frames_of_model.empty() ? momentum
                                       : to_parent(robot.frames_of_model[at(rotor->carrier)].rotation, momentum);
}

std::vector<TracedRotor> rotors_on(const TracedRobot& robot, int link) {
  std::vector<TracedRotor> rotors;
  if (robot.is_base(link) && !robot.floating()) return rotors;
  for (int j = 0; j < static_cast<int>(robot.tree().joints.size()); ++j) {
    const std::optional<model::Rotor>& rotor = robot.tree().joints[at(j)].drive.rotor;
    if (rotor && rotor->carrier == link) rotors.push_back({j, rotor_momentum(robot, j)});
  }
  return rotors;
}

std::vector<RotorMotion> rotor_motions_on(
    const TracedRobot& robot,
    int link,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd) {
  std::vector<RotorMotion> motions;
  for (const TracedRotor& rotor : rotors_on(robot, link))
    motions.push_back({rotor.momentum, qd[at(rotor.joint)], qdd.empty() ? Expression() : qdd[at(rotor.joint)]});
  return motions;
}

Expression smooth_sign(Trace& trace, const model::Drive& drive, const Expression& qd) {
  // Added to v^2, it makes the sign of a zero velocity zero, and it is lost in rounding next to any velocity above
  // 1e-10, in double and in single precision.
  constexpr double kLeastSquare = 1e-36;
  const Expression v = trace.lift(drive.friction_velocity);
  const Expression square = v * v + trace.graph.constant(kLeastSquare);
  return qd / sqrt(qd * qd + square);
}

namespace {

// f s(qd)
Expression friction(Trace& trace, const model::Drive& drive, const Expression& qd) {
  if (drive.friction.is_zero()) return Expression();
  const Expression sign = smooth_sign(trace, drive, qd);
  return trace.lift(drive.friction) * sign;
}

// The passive forces of the joints' own drives, whether the robot's dynamics use them or not.
std::vector<Expression> forces_of_drives(
    Trace& trace,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd) {
  std::vector<Expression> forces(qd.size());
  for (std::size_t j = 0; j < forces.size(); ++j) {
    const model::Joint& joint = trace.tree.joints[j];
    if (!joint.drive.is_passive()) continue;
    trace.section(joint.name, "joint ", ": passive forces");
    forces[j] = trace.lift(joint.drive.damping) * qd[j] + friction(trace, joint.drive, qd[j]);
    if (!joint.drive.stiffness.is_zero())
      forces[j] += trace.lift(joint.drive.stiffness) * (q[j] - trace.lift(joint.drive.rest));
    described("passive", joint.name, forces[j]);
  }
  return forces;
}

void add_tendons(
    Trace& trace,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd,
    std::vector<Expression>& forces) {
  for (const model::Tendon& tendon : trace.tree.tendons) {
    trace.section(tendon.name, "tendon ", ": force");
    const TendonMotion motion = tendon_motion(trace, tendon, q, qd);
    const Expression force = trace.lift(tendon.stiffness) * motion.stretch + trace.lift(tendon.damping) * motion.rate;
    described("tension", tendon.name, force);
    for (const model::Tendon::Term& term : tendon.terms) forces[at(term.joint)] += trace.lift(term.factor) * force;
  }
}

}  // namespace

TendonMotion tendon_motion(
    Trace& trace,
    const model::Tendon& tendon,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd) {
  TendonMotion motion{-trace.lift(tendon.rest), Expression()};
  for (const model::Tendon::Term& term : tendon.terms) {
    const Expression factor = trace.lift(term.factor);
    motion.stretch += factor * q[at(term.joint)];
    motion.rate += factor * qd[at(term.joint)];
  }
  return motion;
}

std::vector<Expression> passive_forces(
    Trace& trace,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd) {
  std::vector<Expression> forces(qd.size());
  if (trace.tree.uses_passive_forces) forces = forces_of_drives(trace, q, qd);
  add_tendons(trace, q, qd, forces);
  return forces;
}

void add_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau) {
  const std::vector<Expression> forces = passive_forces(trace, in.q, in.qd);
  for (std::size_t j = 0; j < tau.size(); ++j) tau[j] += forces[j];
}

void subtract_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau) {
  const std::vector<Expression> forces = by_coordinate(trace, passive_forces(trace, in.q, in.qd));
  for (std::size_t k = 0; k < tau.size(); ++k) tau[k] -= forces[k];
}

symbolic::Program motor_torques(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const StateInputs in(trace, {State::force});
  std::vector<Expression> torques = in.tau;
  const std::vector<int> coordinates = tree.coordinates();
  for (std::size_t k = 0; k < torques.size(); ++k)
    if (const auto& rotor = tree.joints[at(coordinates[k])].drive.rotor)
      torques[k] = torques[k] / trace.lift(rotor->ratio);
  trace.output("torque", symbolic::Role::joint_force, torques);
  return trace.program(name);
}

symbolic::Program passive_forces(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity});
  std::vector<Expression> forces = forces_of_drives(trace, in.q, in.qd);
  add_tendons(trace, in.q, in.qd, forces);
  trace.output("tau", symbolic::Role::joint_force, by_coordinate(trace, forces));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
