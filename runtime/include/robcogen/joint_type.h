// Kinds of joints, for the constants of generated models.
#pragma once

namespace robcogen {

enum class JointType {
  revolute,   // turns about the z axis of the joint frame, rad
  prismatic,  // moves along it, m
};

}  // namespace robcogen
