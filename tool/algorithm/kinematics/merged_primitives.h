// Products of primitive transforms with merged neighbours.
#pragma once

#include <vector>

#include "model/coordinate_transforms.h"

namespace robcogen::algorithm {

// The same product: rotations about one axis become one with the sum of their angles, and translations along one axis
// become one with the sum of their lengths, wherever the factors between them commute. Terms of opposite sign cancel,
// constants add up exactly, and factors that become zero vanish.
std::vector<model::PrimitiveTransform> merged(const std::vector<model::PrimitiveTransform>& primitives);

}  // namespace robcogen::algorithm
