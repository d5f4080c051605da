// Kinds of joints, for the constants of generated models.
#pragma once

namespace robcogen {

enum class JointType {
  revolute,   // turns about the z axis of the joint frame, rad
  prismatic,  // moves along it, m
  helical,    // turns about it, rad, and moves along it by pitch times that angle
  spherical,  // turns freely: one of its three components, about an axis of the child, rad/s
};

// Whether the joint turns; otherwise its position is a length.
constexpr bool turns(JointType type) {
  return type != JointType::prismatic;
}

}  // namespace robcogen
