// Where the frames of a robot are, in the form that costs least to compute with.
#pragma once

#include <string>
#include <vector>

#include "algorithm/trace.h"
#include "model/coordinate_transforms.h"

namespace robcogen::algorithm {

// Pose of a child frame in a parent frame, T = translate(offset) * rotation * translate_z(slide).
//
// The rotation is factorised: quarter turns are pushed to the left, where they are free; neighbouring rotations about
// one axis are merged, so a constant turn about a joint's axis just adds to the joint's angle. A part of the offset
// along the child's own z axis is moved to `slide`, where algorithms get it cheaper.
struct Pose {
  Vector3 offset;     // parent axes
  Rotation rotation;  // child to parent
  Expression slide;   // along the child's z axis
};

// The product of primitive transforms (moved frame on the right) as a pose. `positions` are the values of variables.
Pose pose_of(
    ProgramTrace& trace,
    const std::vector<model::PrimitiveTransform>& primitives,
    const std::vector<Expression>& positions);

// Pose of the child link frame in the parent link frame, of every joint, from the robot's motions document.
std::vector<Pose> joint_poses(Trace& trace, const std::vector<Expression>& q);

}  // namespace robcogen::algorithm
