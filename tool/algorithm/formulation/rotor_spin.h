// Moves the momenta of rotors into the bodies of the robot.
//
// A rotor turns with the rate qd of its joint and has the momentum p qd, with p = J N a fixed in its carrier. If the
// carrier is the parent or the child of the joint, the joint's axis e is fixed in it too. Let p = c e + b. The part c e
// is the momentum of a body on the child that has only a moment of inertia c about e, minus that of the same body on
// the parent:
//     c e e' (w_P + qd e) - c e e' w_P = c qd e.
// So the part along the axis costs nothing but the joint's own inertia, which is J N^2 - c if the parent is the carrier
// and J N^2 + c if the child is. c is chosen such that b has few components: a rotor along its joint's axis has none,
// and costs as much as an armature.
#pragma once

#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// Returns the robot with these bodies, and with rotors of ratio 1 that have the remaining momentum: its dynamics are
// the same. Its bodies are not physical, and its armatures may be negative. Rotors that depend on parameters are kept.
model::KinematicTree with_spin_in_bodies(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
