// Rotors whose spin the bodies of the robot take over.
//
// A rotor turns with the rate qd of its joint and has the momentum p qd, with p = J N a fixed in its carrier. Where
// that is the parent or the child of the joint, the joint's axis e is fixed in it too. Of p = c e + b, the part c e is
// the momentum of a moment of inertia c about e on the child, without mass and about no other axis, less that of the
// same on the parent:
//     c e e' (w_P + qd e) - c e e' w_P = c qd e.
// So the part along the axis costs nothing but the joint's own inertia, J N^2 - c with a carrier that is the parent,
// J N^2 + c with the child. c is chosen such that b has few components: a rotor along its joint has none, and costs
// what an armature does.
#pragma once

#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// The robot with these bodies and with rotors, of ratio 1, that have the momentum that is left: its dynamics are the
// same. Its bodies are not physical, and its armatures may be negative. Rotors that depend on parameters stay what they
// are.
model::KinematicTree with_spin_in_bodies(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
