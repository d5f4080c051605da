// The contribution of drives to the dynamics.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

// The inertia of the joint's drive (armature and rotor), which only the motion of this joint meets; zero without a
// drive.
Expression drive_inertia(Trace& trace, int joint);

// A rotor of inertia J that turns at the rate N qd in its carrier. The mass properties of the carrier include it as if
// it were fixed; its spin adds the momentum J N qd along its axis, which turns with the carrier. (With the angular
// velocity w of the carrier and the axis a, that takes a moment J N (qdd a + qd w x a) on the carrier and J N a . wd at
// the joint, whose own acceleration meets the inertia J N^2.)
struct TracedRotor {
  int joint = 0;
  Vector3 momentum;  // J N a, in the axes of the carrier in the recursions
};
// The rotors on a link; none on a fixed base, which does not turn.
std::vector<TracedRotor> rotors_on(const TracedRobot& robot, int link);
// The motions of these rotors when their joints move. `qdd`: empty for zero accelerations.
std::vector<RotorMotion> rotor_motions_on(
    const TracedRobot& robot,
    int link,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd);

// The path on which the momentum of a joint's rotor, which moves with its carrier, reaches the links between the joint
// and the base: past these joints, nearest the carrier first, to the first link that carries the joint too.
struct RotorPath {
  int carrier = -1;  // link index; -1: the joint has no rotor
  std::vector<int> joints;
  int end = -1;
};
RotorPath rotor_path(const model::KinematicTree& tree, int joint);
// A vector of the carrier, in the axes of the link at the end of the path.
Vector3 to_end(const TracedRobot& robot, const RotorPath& path, Vector3 v);
// The momentum of the joint's rotor per unit rate of the joint, in the axes of its carrier; zero without a rotor.
Vector3 rotor_momentum(const TracedRobot& robot, int joint);
// The same in the axes of this link if the path of the rotor ends there; otherwise zero.
Vector3 rotor_momentum(const TracedRobot& robot, int joint, int link);

// s(qd) = qd / sqrt(qd^2 + v^2), with the velocity v below which the friction of this drive falls: a smooth sign.
Expression smooth_sign(Trace& trace, const model::Drive& drive, const Expression& qd);

// The length of a tendon, less its rest length, and the rate of the length, from positions and rates by joint.
struct TendonMotion {
  Expression stretch, rate;
};
TendonMotion tendon_motion(
    Trace& trace,
    const model::Tendon& tendon,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd);

// The forces that the joints must overcome in their drives, by joint: b qd + f s(qd) + k (q - q0), with
// s(qd) = qd / sqrt(qd^2 + v^2), a smooth form of Coulomb friction. Without v it is the sign of qd, zero at rest. These
// are zero if the robot's dynamics do not use them. The forces of tendons (model/tendon.h) are always part of them.
std::vector<Expression> passive_forces(
    Trace& trace,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd);
// Adds the passive forces to the forces that a motion takes (by joint), or subtracts them from the forces that move the
// robot (by coordinate).
void add_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau);
void subtract_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau);

}  // namespace robcogen::algorithm
