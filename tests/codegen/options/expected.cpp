// The results of the text of the kernels, in long double and on plain arrays.
#include "expected.h"

#include <walker/kernel/centroidal.h>
#include <walker/kernel/coriolis_matrix.h>
#include <walker/kernel/forward_dynamics.h>
#include <walker/kernel/inverse_dynamics.h>
#include <walker/kernel/inverse_dynamics_derivatives.h>
#include <walker/kernel/jacobians.h>
#include <walker/kernel/joint_space_inertia.h>
#include <walker/kernel/joint_space_inertia_factor.h>
#include <walker/kernel/transforms.h>
#include <walker/parameters.h>

#include <array>
#include <cmath>
#include <vector>

namespace options {
namespace {

using Real = long double;
namespace kernel = walker::kernel;

constexpr int kJoints = 4, kSize = 10;

std::vector<Real> real(const double* numbers, int count) {
  return {numbers, numbers + count};
}

std::vector<std::vector<double>> compute() {
  walker::ParameterValues values;
  values.trunk_mass = kTrunkMass;
  walker::Parameters<Real> parameters;
  parameters.update(values);
  const std::vector<Real> q = real(kQ, kJoints), qd = real(kQd, kJoints), qdd = real(kQdd, kJoints);
  const std::vector<Real> twist = real(kTwist, 6), gravity = real(kGravity, 3);
  std::vector<std::vector<Real>> all(static_cast<std::size_t>(Quantity::count));
  const auto result = [&](Quantity quantity, int count) {
    std::vector<Real>& array = all[static_cast<std::size_t>(quantity)];
    array.resize(static_cast<std::size_t>(count));
    return array.data();
  };
  const Real* p = parameters.data();
  Real* tau = result(Quantity::tau, kJoints);
  kernel::inverse_dynamics(
      p, q.data(), qd.data(), qdd.data(), twist.data(), gravity.data(), tau, result(Quantity::base_acceleration, 6));
  std::vector<Real> base(6);
  kernel::forward_dynamics(
      p, q.data(), qd.data(), tau, twist.data(), gravity.data(), result(Quantity::qdd, kJoints), base.data());
  kernel::joint_space_inertia(p, q.data(), result(Quantity::inertia, kSize * kSize));
  kernel::coriolis_matrix(p, q.data(), qd.data(), twist.data(), result(Quantity::coriolis, kSize * kSize));
  std::vector<Real> diagonal(kSize);
  kernel::joint_space_inertia_factor(p, q.data(), result(Quantity::factor, kSize * kSize), diagonal.data());
  kernel::homogeneous_fr_trunk_X_fr_left_foot(p, q.data(), result(Quantity::homogeneous, 16));
  kernel::motion_fr_trunk_X_fr_left_foot(p, q.data(), result(Quantity::motion, 36));
  kernel::force_fr_trunk_X_fr_left_foot(p, q.data(), result(Quantity::force, 36));
  kernel::fr_trunk_J_fr_left_foot(p, q.data(), result(Quantity::jacobian, 12));
  kernel::centroidal_momentum_matrix(p, q.data(), result(Quantity::momentum, 6 * kSize));
  std::vector<Real> wrench(6), forces(kJoints), by_rotation(kSize * 3), by_acceleration(kSize * 6), by_qdd(kSize * 4);
  kernel::inverse_dynamics_fully_actuated_derivatives(
      p, q.data(), qd.data(), qdd.data(), twist.data(), twist.data(), gravity.data(), forces.data(), wrench.data(),
      result(Quantity::d_q, kSize * kJoints), result(Quantity::d_qd, kSize * kJoints), by_qdd.data(),
      by_rotation.data(), result(Quantity::d_base_velocity, kSize * 6), by_acceleration.data());
  std::vector<std::vector<double>> rounded;
  for (const std::vector<Real>& array : all) rounded.emplace_back(array.begin(), array.end());
  return rounded;
}

}  // namespace

const double* expected(Quantity quantity) {
  static const std::vector<std::vector<double>> all = compute();
  return all[static_cast<std::size_t>(quantity)].data();
}

bool agree(double found, double must_be, double tolerance) {
  return std::abs(found - must_be) <= tolerance * (1 + std::abs(must_be));
}

}  // namespace options
