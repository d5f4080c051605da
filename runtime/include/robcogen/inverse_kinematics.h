// Chooses among the branches of generated inverse kinematics.
//
//     namespace ik = arm::inverse_kinematics;
//     const auto branches = ik::fr_base_X_fr_tool(X, reference);
//     const auto best = robcogen::nearest_branch(
//         branches, ik::fr_base_X_fr_tool_joints, arm::kJointTypes, arm::kJointLimits, reference);
//     if (best.branch >= 0) move_to(best.q);
//
// `joints`, `types` and `limits` are constants of the generated library; `branches` is what its function returned.
// Nothing allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

#include "robcogen/arc_tangent.h"
#include "robcogen/joint_limits.h"
#include "robcogen/joint_type.h"
#include "robcogen/sincos_of.h"

namespace robcogen {

template <class JointState>
struct NearestBranch {
  JointState q;                        // the reference where no branch is left
  int branch;                          // -1: no branch exists, or none is within limits
  typename JointState::Scalar misfit;  // of the branch; if there is none, the least of all
};

// A branch whose misfit (rad, m) is above this does not exist.
template <class Scalar>
inline constexpr Scalar kLargestMisfit = Scalar(1e-7);
template <>
inline constexpr float kLargestMisfit<float> = 1e-4F;

namespace inverse_kinematics_detail {

template <class Scalar>
inline constexpr Scalar kTurn = Scalar(6.283185307179586477);

// A position that is beyond a limit by less (rad, m) is at the limit, but for rounding.
template <class Scalar>
inline constexpr Scalar kLimitRounding = Scalar(1e-9);
template <>
inline constexpr float kLimitRounding<float> = 1e-5F;

template <class Scalar>
Scalar clamped(Scalar x, const JointLimits& limits) noexcept {
  return std::min(std::max(x, static_cast<Scalar>(limits.lower)), static_cast<Scalar>(limits.upper));
}

// The angle that differs from q by whole turns and is nearest to the reference, or the nearest of those within limits.
template <class Scalar>
Scalar turned_to(Scalar q, Scalar reference, const JointLimits& limits) noexcept {
  // Twice, so that no angle that was allowed is turned away by the rounding of these sums.
  constexpr Scalar turn = kTurn<Scalar>, rounding = 2 * kLimitRounding<Scalar>;
  Scalar x = q + turn * std::round((reference - q) / turn);
  const Scalar lower = static_cast<Scalar>(limits.lower) - rounding,
               upper = static_cast<Scalar>(limits.upper) + rounding;
  if (x > upper) x -= turn * std::ceil((x - upper) / turn);
  if (x < lower) x += turn * std::ceil((lower - x) / turn);
  return clamped(x, limits);
}

// What branches are compared with: an angle lies within limits, up to whole turns, if its distance from the middle is
// at most half the range. Their sines and cosines tell, so the choice needs no arc tangent.
template <class Scalar, std::size_t kCount>
struct Wanted {
  enum Angle { reference, middle, half };
  std::array<Scalar, 3 * kCount> angles{}, sines{}, cosines{};
  std::array<bool, kCount> is_limited{};
  bool is_empty = false;  // no position is within the limits

  Scalar sine(Angle angle, std::size_t k) const { return sines[kCount * angle + k]; }
  Scalar cosine(Angle angle, std::size_t k) const { return cosines[kCount * angle + k]; }

  void set(std::size_t k, Scalar position, const JointLimits& limits) noexcept {
    const double range = limits.upper - limits.lower;
    angles[k] = position;
    is_empty = is_empty || range < 0;
    is_limited[k] = range < kTurn<double>;
    angles[kCount + k] = is_limited[k] ? static_cast<Scalar>((limits.lower + limits.upper) / 2) : Scalar(0);
    angles[2 * kCount + k] = is_limited[k] ? static_cast<Scalar>(range / 2) : Scalar(0);
  }

  void compute() noexcept { sincos_of<static_cast<int>(3 * kCount)>(angles.data(), sines.data(), cosines.data()); }

  bool allows(std::size_t k, Scalar s, Scalar c) const noexcept {
    if (!is_limited[k]) return true;
    const Scalar along = c * cosine(middle, k) + s * sine(middle, k);
    const Scalar across = std::abs(s * cosine(middle, k) - c * sine(middle, k));
    // The sine of how far the angle is beyond a limit, unless that is half a turn.
    return across * cosine(half, k) - along * sine(half, k) <= kLimitRounding<Scalar> && along > cosine(half, k) - 1;
  }

  Scalar distance(std::size_t k, Scalar s, Scalar c) const noexcept {
    return 2 - 2 * (c * cosine(reference, k) + s * sine(reference, k));
  }
};

}  // namespace inverse_kinematics_detail

// The joint positions of a branch: angles from -pi to pi. Joints outside the chain keep the positions of `reference`.
template <class Branches, class Joints, class Types, class JointState>
JointState branch_positions(
    const Branches& branches,
    const Joints& joints,
    const Types& types,
    int branch,
    const JointState& reference) noexcept {
  constexpr auto kCount = static_cast<int>(std::tuple_size<Joints>::value);
  typename JointState::Scalar angles[kCount];
  arc_tangents_of<kCount>(branches.sin_q.data() + kCount * branch, branches.cos_q.data() + kCount * branch, angles);
  JointState q = reference;
  for (int row = 0; row < kCount; ++row) {
    const int joint = static_cast<int>(joints[static_cast<std::size_t>(row)]);
    const bool slides = types[static_cast<std::size_t>(joint)] == JointType::prismatic;
    q[joint] = slides ? branches.sin_q(row, branch) : angles[row];
  }
  return q;
}

// The positions in all branches, a column each; the rows are those of `sin_q`. Their arc tangents are computed
// together, in half of the time that the branches take one by one.
template <class Branches, class Joints, class Types>
auto branch_positions(const Branches& branches, const Joints& joints, const Types& types) noexcept {
  auto q = branches.sin_q;
  constexpr int kCount = decltype(q)::SizeAtCompileTime;
  arc_tangents_of<kCount>(branches.sin_q.data(), branches.cos_q.data(), q.data());
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto row = static_cast<int>(k);
    if (types[static_cast<std::size_t>(joints[k])] == JointType::prismatic) q.row(row) = branches.sin_q.row(row);
  }
  return q;
}

// The branch that exists, is within limits (up to 1e-9 rad or m; 1e-5 in single precision), and is nearest to the
// reference: the sum of 2 - 2 cos(q - reference) over joints that turn, and of squared distances over those that slide,
// is least. Angles of the result are within limits, and otherwise nearest to the reference, which may be several turns
// away from zero. Only its arc tangents are computed.
template <class Branches, class Joints, class Types, class Limits, class JointState>
NearestBranch<JointState> nearest_branch(
    const Branches& branches,
    const Joints& joints,
    const Types& types,
    const Limits& limits,
    const JointState& reference,
    typename JointState::Scalar largest_misfit = kLargestMisfit<typename JointState::Scalar>) noexcept {
  using Scalar = typename JointState::Scalar;
  namespace detail = inverse_kinematics_detail;
  constexpr std::size_t kCount = std::tuple_size<Joints>::value;
  const auto joint_of = [&](std::size_t k) { return static_cast<int>(joints[k]); };
  const auto limits_of = [&](std::size_t k) -> const JointLimits& {
    return limits[static_cast<std::size_t>(joints[k])];
  };
  const auto slides = [&](std::size_t k) { return types[static_cast<std::size_t>(joints[k])] == JointType::prismatic; };
  detail::Wanted<Scalar, kCount> wanted;
  for (std::size_t k = 0; k < kCount; ++k) wanted.set(k, reference[joint_of(k)], limits_of(k));
  wanted.compute();

  NearestBranch<JointState> best{reference, -1, std::numeric_limits<Scalar>::infinity()};
  Scalar least = std::numeric_limits<Scalar>::infinity();
  const auto count = static_cast<int>(branches.misfit.size());
  for (int branch = 0; branch < count; ++branch) {
    const Scalar misfit = branches.misfit[branch];
    if (best.branch < 0 && misfit < best.misfit) best.misfit = misfit;
    if (!(misfit <= largest_misfit)) continue;
    Scalar distance = 0;
    bool is_allowed = !wanted.is_empty;
    for (std::size_t k = 0; k < kCount && is_allowed; ++k) {
      const auto row = static_cast<int>(k);
      const Scalar s = branches.sin_q(row, branch), c = branches.cos_q(row, branch);
      if (slides(k)) {
        distance += (s - reference[joint_of(k)]) * (s - reference[joint_of(k)]);
        is_allowed = std::abs(s - detail::clamped(s, limits_of(k))) <= detail::kLimitRounding<Scalar>;
      } else {
        distance += wanted.distance(k, s, c);
        is_allowed = wanted.allows(k, s, c);
      }
    }
    if (!is_allowed || !(distance < least)) continue;
    least = distance;
    best.branch = branch;
    best.misfit = misfit;
  }
  if (best.branch < 0) return best;
  best.q = branch_positions(branches, joints, types, best.branch, reference);
  for (std::size_t k = 0; k < kCount; ++k) {
    Scalar& q = best.q[joint_of(k)];
    q = slides(k) ? detail::clamped(q, limits_of(k)) : detail::turned_to(q, reference[joint_of(k)], limits_of(k));
  }
  return best;
}

}  // namespace robcogen
