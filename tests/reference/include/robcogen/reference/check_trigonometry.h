// Checks of functions that take precomputed sines and cosines, against the same functions of positions.
#pragma once

#include <limits>
#include <vector>

#include "robcogen/reference/check_identities.h"

namespace robcogen::reference {

inline constexpr Tolerance kOtherRounding{
    "kOtherRounding", 1e-13,
    "sines and cosines of other rounding, in sums of another order; relative to the function's largest result"};
inline constexpr Tolerance kOtherRoundingDivided{
    "kOtherRoundingDivided", 1e-9, "the same, carried through the inverse of a matrix of any condition"};

inline bool divides(const reflection::Function& f) {
  return f.count.div > 0 || f.count.sqrt > 0;
}

// Records the difference between a function's results and those computed in another way.
inline void record_other_rounding(
    Checks& checks,
    const std::string& name,
    const reflection::Function& f,
    Real relative_difference) {
  const std::string which = divides(f) ? ", with divisions" : "";
  checks.record(name + which, divides(f) ? kOtherRoundingDivided : kOtherRounding, relative_difference, 0);
}

// Sines of fewer angles may be computed by the C library; those of all joints together are not.
inline constexpr int kComputedTogether = 4;

// The largest difference between results computed in two ways, relative to the largest result of all calls, because
// sums may cancel in any one.
class Difference {
 public:
  // A NaN on one side only is an infinite error.
  void add(const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::isnan(a[i]) && std::isnan(b[i])) continue;
      if (std::isnan(a[i]) || std::isnan(b[i])) difference_ = std::numeric_limits<Real>::infinity();
      largest_ = std::max(largest_, std::abs(static_cast<Real>(a[i])));
      difference_ = std::max(difference_, std::abs(static_cast<Real>(a[i]) - static_cast<Real>(b[i])));
    }
  }

  Real relative() const { return largest_ > 0 ? difference_ / largest_ : difference_; }

 private:
  Real largest_ = 0;
  Real difference_ = 0;
};

// Moderate numbers for all inputs, preceded by the cache of a robot with parameters.
inline std::vector<double> random_inputs(
    std::mt19937_64& engine,
    const Robot& robot,
    const reflection::Function& f,
    const std::vector<double>& cache) {
  std::vector<double> inputs(static_cast<std::size_t>(f.inputs));
  for (double& x : inputs) x = uniform(engine, 3);
  std::copy(cache.begin(), cache.end(), inputs.begin());
  for (int j = 0; f.positions >= 0 && j < robot.dof(); ++j) {
    if (robot.joints[j].type != JointType::spherical || robot.is_follower(j)) continue;
    const Vector<double> quaternion = unit_vector(engine, 4);
    std::copy(quaternion.data(), quaternion.data() + 4, inputs.begin() + f.positions + robot.position_of(j) - 1);
  }
  return inputs;
}

// Checks one function in many states. `cache` is empty if the robot has no parameters.
inline void check_core(
    const Robot& robot,
    const reflection::Function& f,
    const std::vector<double>& cache,
    std::mt19937_64& engine,
    int samples,
    Checks& checks) {
  const auto angles = static_cast<std::size_t>(robot.trigonometry.angles);
  const auto joints = static_cast<std::size_t>(robot.dof()), outputs = static_cast<std::size_t>(f.outputs);
  std::vector<double> sine(angles), cosine(angles), sin_joint(joints), cos_joint(joints);
  std::vector<double> expected(outputs), found(outputs);
  Difference computed, given;
  for (int i = 0; i < samples; ++i) {
    const std::vector<double> in = random_inputs(engine, robot, f, cache);
    const double* q = in.data() + f.positions;
    f.call(in.data(), expected.data());

    robot.trigonometry.compute(in.data(), q, sine.data(), cosine.data());
    f.call_core(in.data(), sine.data(), cosine.data(), found.data());
    computed.add(expected, found);

    for (std::size_t k = 0; k < joints; ++k) {
      sin_joint[k] = std::sin(q[k]);
      cos_joint[k] = std::cos(q[k]);
    }
    robot.trigonometry.complete(in.data(), sin_joint.data(), cos_joint.data(), sine.data(), cosine.data());
    f.call_core(in.data(), sine.data(), cosine.data(), found.data());
    given.add(expected, found);
  }
  // If many sines are read, they are the same; but kernels whose limbs share lanes add in another order than their
  // cores.
  const std::string few = f.count.sincos >= kComputedTogether ? "" : ", few read";
  record_other_rounding(checks, "sines and cosines of all joints" + few, f, computed.relative());
  record_other_rounding(checks, "sines and cosines that are given", f, given.relative());
}

// Checks every function that reads sines or cosines of joints.
inline void check_trigonometry(
    const Robot& robot,
    const std::vector<double>& cache,
    std::mt19937_64& engine,
    int samples,
    Checks& checks) {
  for (const reflection::Function& f : robot.functions)
    if (f.call_core != nullptr) check_core(robot, f, cache, engine, samples, checks);
}

}  // namespace robcogen::reference
