// Rotations given by matrices and quaternions.
#pragma once

#include <array>

#include "import/pose.h"

namespace robcogen::import {

// The rotation with this matrix, given by rows. Angles within rounding of a multiple of PI/4 are exact.
Rotation rotation_of_matrix(const std::array<std::array<long double, 3>, 3>& rows);
// The same for a quaternion w, x, y, z of any length but zero.
Rotation rotation_of_quaternion(const std::array<long double, 4>& wxyz);

}  // namespace robcogen::import
