// The pose of a frame in another, in the form that costs least to compute with.
#pragma once

#include <string>
#include <vector>

#include "algorithm/spatial/motion_force.h"
#include "algorithm/spatial/rotation.h"
#include "algorithm/spatial/trace.h"
#include "model/coordinate_transforms.h"

namespace robcogen::algorithm {

// Pose of a child frame in a parent frame, T = translate(offset) * rotation * translate_z(slide).
//
// The rotation is factorised: quarter turns are pushed to the left, where they are free; neighbouring rotations about
// one axis are merged, so a constant turn about a joint's axis just adds to the joint's angle. A part of the offset
// along the child's own z axis is moved to `slide`, where it costs less.
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

// A force on the child C, about the parent's origin in the parent's axes.
Force to_parent(const Pose& X_PC, const Force& F_C);
// The motion of a body, from the child's origin and axes to the parent's origin and axes; and back.
Motion to_parent(const Pose& X_PC, const Motion& V_C);
Motion to_child(const Pose& X_PC, const Motion& V_P);

}  // namespace robcogen::algorithm
