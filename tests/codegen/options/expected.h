// What a user's part must get from the library: computed from the text of the kernels in long double, column by column.
#pragma once

namespace options {

enum class Quantity {
  tau,
  base_acceleration,
  qdd,
  inertia,
  coriolis,
  factor,
  homogeneous,
  motion,
  force,
  jacobian,
  momentum,
  d_q,
  d_qd,
  d_base_velocity,
  count
};

// Inputs are these numbers, one after another.
constexpr double kQ[4] = {0.4, -0.7, 1.1, 0.2}, kQd[4] = {0.3, -0.5, 0.8, -0.1}, kQdd[4] = {1.0, 0.5, -2.0, 0.7};
constexpr double kTwist[6] = {0.1, -0.2, 0.3, 0.4, -0.5, 0.6}, kGravity[3] = {0.5, -0.7, -9.7};
constexpr double kTrunkMass = 7.5;

// Whether two numbers differ by at most this part of 1 + |must_be|. A NaN agrees with nothing, which -ffast-math would
// not notice.
bool agree(double found, double must_be, double tolerance);

// Pointers only, so that no option changes how the two parts call each other.
const double* expected(Quantity quantity);

}  // namespace options
