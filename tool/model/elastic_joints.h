// Series-elastic joints, in descriptions: a spring connects the joint to its motor, which has a coordinate of its own.
#pragma once

#include <string>

#include "model/description.h"

namespace robcogen::model {

// The names of what stands for the motor of an elastic joint, and of its spring.
std::string motor_name(const std::string& joint);
std::string motor_link_name(const std::string& joint);
std::string elasticity_name(const std::string& joint);

// Gives each joint with an elasticity a motor, in a description that already has all links and joints (Spong 1987). The
// motor is a joint beside it: with the same axis, on the same link, and with a massless child, so that it has no
// position in space that matters. It takes the armature, the rotor and the limit of effort of the joint. A tendon pulls
// the two together. Motors come after all other joints, in the order of their joints. Reports joints without inertia
// for a motor, without stiffness or without a single axis, and names of motors that others have.
void add_motors(Description& description, Diagnostics& diagnostics);

}  // namespace robcogen::model
