// Products of primitive transforms, with as few factors as neighbours about one axis leave.
#pragma once

#include <vector>

#include "model/coordinate_transforms.h"

namespace robcogen::algorithm {

// The same product: rotations about one axis become one by the sum of their angles, translations along one axis one by
// the sum of their lengths, wherever what stands between them commutes. Terms of opposite sign cancel, constants add up
// exactly, and what becomes zero vanishes.
std::vector<model::PrimitiveTransform> merged(const std::vector<model::PrimitiveTransform>& primitives);

}  // namespace robcogen::algorithm
