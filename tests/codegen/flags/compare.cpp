// Compares flagged.cpp, compiled with any flags, with the same kernels in long double, compiled here without any of
// these flags: in states of usual size, with large angles, and with a NaN.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

#include "flagged.h"
#include "hyl/kernel/forward_dynamics.h"
#include "hyl/kernel/inverse_dynamics.h"
#include "quadruped/kernel/inverse_dynamics.h"

namespace {

using Real = long double;

// Relative to the largest result of a call. Doubles lose digits in states where terms cancel.
template <class Scalar>
constexpr Real kKernelTolerance = 1e-12L;
template <>
constexpr Real kKernelTolerance<float> = 1e-4L;
// For sines: twice the bound of robcogen/sincos_of.h without such flags.
template <class Scalar>
constexpr Real kSineTolerance = std::numeric_limits<Scalar>::epsilon() * (sizeof(Scalar) == 4 ? 1.5L : 1);

int failures = 0;

void expect(bool holds, const char* what, int precision, int index, Real found, Real expected) {
  if (holds || ++failures > 20) return;
  std::printf("%s, %d bytes, number %d: is %.17Lg, must be %.17Lg\n", what, precision, index, found, expected);
}

// A NaN stays a NaN, and does not arise from anything else.
template <class Scalar>
void compare(
    const char* what,
    const std::vector<Scalar>& found,
    const std::vector<Real>& expected,
    Real tolerance,
    Real scale) {
  for (const Real x : expected)
    if (std::isfinite(x)) scale = std::max(scale, std::abs(x));
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool both = std::isfinite(found[i]) && std::isfinite(expected[i]);
    const bool none = !std::isfinite(found[i]) && !std::isfinite(expected[i]);
    const bool is_near = both && std::abs(static_cast<Real>(found[i]) - expected[i]) <= tolerance * scale;
    expect(is_near || none, what, sizeof(Scalar), static_cast<int>(i), found[i], expected[i]);
  }
}

std::mt19937_64 generator(1);

template <class Scalar>
std::vector<Scalar> random_numbers(int count, double size) {
  std::uniform_real_distribution<double> unit(-size, size);
  std::vector<Scalar> result(static_cast<std::size_t>(count));
  for (Scalar& x : result) x = static_cast<Scalar>(unit(generator));
  return result;
}

template <class Scalar>
std::vector<Real> real(const std::vector<Scalar>& x) {
  return {x.begin(), x.end()};
}

template <class Scalar>
void check_leg(std::vector<Scalar> q) {
  q.resize(flagged::kLegJoints);
  const auto qd = random_numbers<Scalar>(flagged::kLegJoints, 1), qdd = random_numbers<Scalar>(flagged::kLegJoints, 1);
  std::vector<Scalar> found(q.size());
  std::vector<Real> expected(q.size());
  flagged::inverse_dynamics_of_leg(q.data(), qd.data(), qdd.data(), found.data());
  hyl::kernel::inverse_dynamics(real(q).data(), real(qd).data(), real(qdd).data(), expected.data());
  compare("inverse dynamics of hyl", found, expected, kKernelTolerance<Scalar>, 1);
  flagged::forward_dynamics_of_leg(q.data(), qd.data(), qdd.data(), found.data());
  hyl::kernel::forward_dynamics(real(q).data(), real(qd).data(), real(qdd).data(), expected.data());
  compare("forward dynamics of hyl", found, expected, kKernelTolerance<Scalar>, 1);
}

template <class Scalar>
void check_legs(const std::vector<Scalar>& q) {
  const auto qd = random_numbers<Scalar>(flagged::kLegsJoints, 1),
             qdd = random_numbers<Scalar>(flagged::kLegsJoints, 1), velocity = random_numbers<Scalar>(6, 1),
             gravity = random_numbers<Scalar>(3, 10);
  std::vector<Scalar> found(flagged::kLegsResults);
  std::vector<Real> expected(flagged::kLegsResults);
  flagged::inverse_dynamics_of_legs(q.data(), qd.data(), qdd.data(), velocity.data(), gravity.data(), found.data());
  quadruped::kernel::inverse_dynamics(
      real(q).data(), real(qd).data(), real(qdd).data(), real(velocity).data(), real(gravity).data(), expected.data(),
      expected.data() + flagged::kLegsJoints);
  compare("inverse dynamics of quadruped", found, expected, kKernelTolerance<Scalar>, 1);
}

template <class Scalar>
void check_sines(const std::vector<Scalar>& q) {
  for (const bool in_lanes : {false, true}) {
    const std::size_t count = in_lanes ? 8 : flagged::kAngles;
    std::vector<Scalar> sine(count), cosine(count);
    in_lanes ? flagged::sines_in_lanes(q.data(), sine.data(), cosine.data())
             : flagged::sines(q.data(), sine.data(), cosine.data());
    std::vector<Real> sine_expected(count), cosine_expected(count);
    for (std::size_t i = 0; i < count; ++i) {
      sine_expected[i] = std::sin(static_cast<Real>(q[i]));
      cosine_expected[i] = std::cos(static_cast<Real>(q[i]));
    }
    compare(in_lanes ? "sine in lanes" : "sine", sine, sine_expected, kSineTolerance<Scalar>, 1);
    compare(in_lanes ? "cosine in lanes" : "cosine", cosine, cosine_expected, kSineTolerance<Scalar>, 1);
  }
}

template <class Scalar>
void check_in(const std::vector<Scalar>& q) {
  check_sines(q);
  check_leg(q);
  check_legs(q);
}

template <class Scalar>
void check() {
  constexpr Scalar kNaN = std::numeric_limits<Scalar>::quiet_NaN(), kInfinity = std::numeric_limits<Scalar>::infinity();
  for (const double size : {0.1, 3.0, 100.0, 390.0, 5e3, 9e4, 1e6})
    for (int i = 0; i < 50; ++i) check_in(random_numbers<Scalar>(flagged::kLegsJoints, size));
  for (const Scalar odd : {kNaN, kInfinity, -kInfinity, Scalar(1e5), Scalar(-1e9), Scalar(401), Scalar(120.5)})
    for (std::size_t place = 0; place < flagged::kLegsJoints; ++place) {
      auto q = random_numbers<Scalar>(flagged::kLegsJoints, 3);
      q[place] = odd;
      check_in(q);
    }
}

}  // namespace

int main() {
  check<double>();
  check<float>();
  std::printf("%d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
