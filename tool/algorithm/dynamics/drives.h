// What the drives of joints add to the dynamics.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

// The inertia that the motion of this joint alone meets in its drive, armature and rotor; zero without one.
Expression drive_inertia(Trace& trace, int joint);

// A rotor of inertia J that turns with N qd in its carrier, whose mass properties include it as if it were fixed. What
// the spin adds is the momentum J N qd along the axis, which turns with the carrier. (With the angular velocity w of
// the carrier, and the axis a: a moment J N (qdd a + qd w x a) on the carrier, and J N a . wd on the joint, whose own
// acceleration meets J N^2.)
struct TracedRotor {
  int joint = 0;
  Vector3 momentum;  // J N a, in the axes that the recursions see the carrier in
};
// The rotors on a link; none on a fixed base, which does not turn.
std::vector<TracedRotor> rotors_on(const TracedRobot& robot, int link);
// The same as they turn with their joints. `qdd`: empty for none.
std::vector<Spin> spins_on(
    const TracedRobot& robot,
    int link,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd);

// How the momentum of a joint's rotor, which moves with the carrier, reaches the links between the joint and the base:
// past these joints, nearest the carrier first, to the first link that carries the joint too.
struct RotorPath {
  int carrier = -1;  // link index; -1: the joint has no rotor
  std::vector<int> joints;
  int end = -1;
};
RotorPath rotor_path(const model::KinematicTree& tree, int joint);
// A vector that is fixed in the carrier, in the axes of the link at the end.
Vector3 to_end(const TracedRobot& robot, const RotorPath& path, Vector3 v);
// The momentum of the joint's rotor, in the axes of its carrier; zero without one.
Vector3 rotor_momentum(const TracedRobot& robot, int joint);
// The same if the path of the rotor ends at this link, in the axes of that; else zero.
Vector3 rotor_momentum(const TracedRobot& robot, int joint, int link);

// s(qd) = qd / sqrt(qd^2 + v^2), with the velocity v below which the friction of this drive falls: a smooth sign.
Expression smooth_sign(Trace& trace, const model::Drive& drive, const Expression& qd);

// The forces that the joints have to overcome in their drives, by joint: b qd + f s(qd) + k (q - q0), with
// s(qd) = qd / sqrt(qd^2 + v^2), a smooth form of Coulomb friction. Without v it is the sign of qd, zero at rest.
// All are zero where the robot's dynamics do not use them.
std::vector<Expression> passive_forces(
    Trace& trace,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd);
// Adds them to the forces that a motion takes, by joint, or subtracts them from those that are there to move the robot,
// by coordinate.
void add_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau);
void subtract_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau);

}  // namespace robcogen::algorithm
