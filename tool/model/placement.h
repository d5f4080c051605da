// Where a frame is.
#pragma once

#include <array>

#include "model/quantity.h"

namespace robcogen::model {

// Pose of a frame in the frame of its parent: translate, then rotate about the intrinsic axes x, y', z''
// (R = Rx Ry Rz). Metres and radians.
struct Placement {
  std::array<Quantity, 3> translation;
  std::array<Quantity, 3> rotation;
};

}  // namespace robcogen::model
