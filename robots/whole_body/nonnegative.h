// Quadratic programs whose variables are not negative: minimise x' Q x / 2 - c' x, x >= 0.
#pragma once

#include <Eigen/Core>

namespace whole_body {

// Enough for the edges of all friction cones. Nothing allocates.
inline constexpr int kMaxVariables = 32;
using NonnegativeVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxVariables, 1>;
using NonnegativeMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxVariables, kMaxVariables>;

// Solves the program by active sets (Lawson and Hanson 1974, ch. 23, for normal equations). Q is symmetric and positive
// definite. Starts from x, whose positive variables are those that were free in the last call, and returns the number
// of systems that it solved, or -1 if it has not ended after 4 kMaxVariables of them.
int minimise_nonnegative(const NonnegativeMatrix& Q, const NonnegativeVector& c, NonnegativeVector& x);

}  // namespace whole_body
