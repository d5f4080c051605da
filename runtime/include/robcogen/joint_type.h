// Kinds of joints, for the constants of generated models.
#pragma once

namespace robcogen {

enum class JointType {
  revolute,   // turns about the z axis of the joint frame, rad
  prismatic,  // moves along it, m
  helical,    // turns about it, rad, and moves along it by pitch times that angle
  spherical,  // turns in any way: four positions, a unit quaternion, and three velocities
};

// Elements of q, and of qd, that a joint has.
constexpr int position_count(JointType type) {
  return type == JointType::spherical ? 4 : 1;
}
constexpr int velocity_count(JointType type) {
  return type == JointType::spherical ? 3 : 1;
}

// Whether the joint turns; else its position is a length.
constexpr bool turns(JointType type) {
  return type != JointType::prismatic;
}

}  // namespace robcogen
