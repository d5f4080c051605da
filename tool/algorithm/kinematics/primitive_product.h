// A coordinate transform as a plain product of primitives, as in a document of transforms, for users who have
// primitives of their own.
#pragma once

#include <string>
#include <vector>

#include "model/coordinate_transforms.h"
#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

struct PrimitiveProduct {
  std::vector<model::PrimitiveTransform> primitives;  // first one leftmost
  symbolic::Program amounts;                          // q -> amounts of the primitives, a row for each (m, rad)
};

// left_X_right. `position` is the convention of the primitives: right: Rx(a) maps coordinates of the frame rotated by
// +a to the original frame; left: the inverse.
PrimitiveProduct primitive_product(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    model::MovedFramePosition position);

}  // namespace robcogen::algorithm
