// The placement of a frame.
#pragma once

#include <array>

#include "model/quantity.h"

namespace robcogen::model {

// The pose of a frame in its parent frame: translate, then rotate about the intrinsic axes x, y', z'' (R = Rx Ry Rz).
// Metres and radians.
struct Placement {
  std::array<Quantity, 3> translation;
  std::array<Quantity, 3> rotation;
};

}  // namespace robcogen::model
