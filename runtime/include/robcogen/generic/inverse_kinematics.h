// Inverse kinematics for any chain of joints, by damped least squares: one step, or a search. Needs C++20.
//
// Transforms and Jacobians have different names in each library, so the caller provides them:
//
//     struct Foot {
//       using JointState = hyl::JointState;
//       static auto pose(const JointState& q) { return hyl::transforms::homogeneous::fr_base_X_fr_foot(q); }
//       static auto jacobian(const JointState& q) { return hyl::jacobians::fr_base_J_fr_foot(q); }
//       static constexpr auto kColumns = hyl::jacobians::fr_base_J_fr_foot_columns;
//     };
//     q = inverse_kinematics_step(Foot(), q, target, 1e-6);
//     const auto found = inverse_kinematics(Foot(), q, target);    // within limits, from several starts
//
// Nothing allocates.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "robcogen/matrix.h"

namespace robcogen {

// A chain from a frame A to a frame B: pose(q) is A_X_B (4 x 4), and jacobian(q) is A_J_B (6 rows), with one column for
// each joint that kColumns lists.
template <class C>
concept KinematicChain = requires(const C& chain, const typename C::JointState& q) {
  requires decltype(chain.pose(q))::RowsAtCompileTime == 4;
  requires decltype(chain.jacobian(q))::RowsAtCompileTime == 6;
  requires decltype(chain.jacobian(q))::ColsAtCompileTime == static_cast<int>(C::kColumns.size());
};

// The motion from one pose to another: the axis times the angle of the rotation (rad), at most half a turn, then the
// displacement of the origin (m). It is in coordinates of the frame in which both poses are given.
template <class Scalar>
Eigen::Matrix<Scalar, 6, 1> pose_error(const Matrix<Scalar, 4, 4>& from, const Matrix<Scalar, 4, 4>& to) noexcept {
  using Matrix3 = Matrix<Scalar, 3, 3>;
  const Matrix3 turn = to.template topLeftCorner<3, 3>() * from.template topLeftCorner<3, 3>().transpose();
  const Eigen::AngleAxis<Scalar> rotation(turn);
  Eigen::Matrix<Scalar, 6, 1> error;
  error << rotation.angle() * rotation.axis(),
      to.template topRightCorner<3, 1>() - from.template topRightCorner<3, 1>();
  return error;
}

namespace inverse_kinematics_detail {

// J^T (J J^T + mu)^-1 e with the Cholesky factor L of the inner matrix, for numbers or lanes. These are loops because
// Eigen's solver of this size takes several seconds to compile.
template <int kCount, class Jacobian, class Error, class Number>
std::array<Number, static_cast<std::size_t>(kCount)> damped_step(
    const Jacobian& J,
    const Error& e,
    const Number& mu) noexcept {
  using std::sqrt;
  Number L[6][6], x[6];
  for (int i = 0; i < 6; ++i) {
    x[i] = e[i];
    for (int j = 0; j <= i; ++j) {
      Number sum = i == j ? mu : Number(0);
      for (int k = 0; k < kCount; ++k) sum = sum + J(i, k) * J(j, k);
      for (int k = 0; k < j; ++k) sum = sum - L[i][k] * L[j][k];
      L[i][j] = i == j ? sqrt(sum) : sum / L[j][j];
      if (j < i) x[i] = x[i] - L[i][j] * x[j];
    }
    x[i] = x[i] / L[i][i];
  }
  for (int i = 5; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k) x[i] = x[i] - L[k][i] * x[k];
    x[i] = x[i] / L[i][i];
  }
  std::array<Number, static_cast<std::size_t>(kCount)> step;
  for (int k = 0; k < kCount; ++k) {
    Number sum = Number(0);
    for (int i = 0; i < 6; ++i) sum = sum + J(i, k) * x[i];
    step[static_cast<std::size_t>(k)] = sum;
  }
  return step;
}

}  // namespace inverse_kinematics_detail

// Returns the joint positions after one step towards `target`, a pose like chain.pose(q): q + J^T (J J^T + mu)^-1 e
// with the pose error e and mu = damping + |e|^2 / 2. The damping (positive) keeps steps short at singularities; the
// second term keeps them short for far targets and vanishes at the target (Sugihara, IEEE T-RO 27(5), 2011). Rotations
// (rad) and displacements (m) have equal weight; joints outside the chain do not move.
template <KinematicChain C>
typename C::JointState inverse_kinematics_step(
    const C& chain,
    const typename C::JointState& q,
    const Matrix<typename C::JointState::Scalar, 4, 4>& target,
    typename C::JointState::Scalar damping) noexcept {
  using Scalar = typename C::JointState::Scalar;
  const Eigen::Matrix<Scalar, 6, 1> error = pose_error<Scalar>(chain.pose(q), target);
  const auto step = inverse_kinematics_detail::damped_step<static_cast<int>(C::kColumns.size())>(
      chain.jacobian(q), error, damping + error.squaredNorm() / 2);
  typename C::JointState result = q;
  std::size_t row = 0;
  for (const auto joint : C::kColumns) result[static_cast<int>(joint)] += step[row++];
  return result;
}

// How inverse_kinematics searches. The positions of joints lie within the limits; joints without limits have infinite
// ones, and starts are drawn for them within half a turn.
template <class JointState>
struct InverseKinematicsOptions {
  using Scalar = typename JointState::Scalar;
  JointState lower = JointState::Constant(-std::numeric_limits<Scalar>::infinity());
  JointState upper = JointState::Constant(std::numeric_limits<Scalar>::infinity());
  Scalar tolerance = std::is_same_v<Scalar, float> ? Scalar(1e-5) : Scalar(1e-9);  // of each element of the error
  Scalar length = Scalar(0.3);                                                     // m that count like 1 rad
  Scalar damping = Scalar(1e-6);
  int steps = 20;  // of each start
  int starts = 16;
  std::uint64_t seed = 1;  // of the starts
};

template <class JointState>
struct InverseKinematicsResult {
  JointState q;                       // the best positions found, within limits
  typename JointState::Scalar error;  // the largest element of the pose error there (rad; m by `length`)
  int steps;                          // of all starts
  bool found;                         // whether the error is within the tolerance
};

namespace inverse_kinematics_detail {

// Uniform numbers in [0, 1), the same on all machines (Steele, Lea, Flood 2014).
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : state_(seed) {}
  double operator()() noexcept {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

// The search in one call.
template <KinematicChain C>
class Search {
 public:
  using JointState = typename C::JointState;
  using Scalar = typename JointState::Scalar;
  using Vector6 = Eigen::Matrix<Scalar, 6, 1>;
  using Options = InverseKinematicsOptions<JointState>;

  Search(const C& chain, const Matrix<Scalar, 4, 4>& target, const Options& options)
      : chain_(chain), target_(target), options_(options), uniform_(options.seed) {}

  InverseKinematicsResult<JointState> from(const JointState& q) noexcept {
    InverseKinematicsResult<JointState> best{q, std::numeric_limits<Scalar>::infinity(), 0, false};
    for (const auto joint : C::kColumns) into_limits(best.q, static_cast<int>(joint));
    JointState here = best.q;
    for (int start = 0; start < options_.starts && !best.found; ++start) {
      if (start > 0) here = drawn(q);
      descend(here, best);
    }
    return best;
  }

 private:
  static constexpr int kCount = static_cast<int>(C::kColumns.size());
  static constexpr int kDrawn = 16;  // positions, the best of which is a start
  using Joints = Eigen::Matrix<Scalar, kCount, 1>;

  const C& chain_;
  const Matrix<Scalar, 4, 4>& target_;
  const Options& options_;
  Uniform uniform_;

  static constexpr Scalar kPi = Scalar(3.141592653589793238);

  static int joint(int row) { return static_cast<int>(C::kColumns[static_cast<std::size_t>(row)]); }

  Vector6 error(const JointState& q) const {
    Vector6 e = pose_error<Scalar>(chain_.pose(q), target_);
    e.template tail<3>() /= options_.length;
    return e;
  }

  // Whole turns are free where the limits allow one.
  void into_limits(JointState& q, int j) const {
    const Scalar lower = options_.lower[j], upper = options_.upper[j];
    if (q[j] >= lower && q[j] <= upper) return;
    if (std::isfinite(lower) && std::isfinite(upper) && upper - lower >= 2 * kPi)
      q[j] -= 2 * kPi * std::floor((q[j] - lower) / (2 * kPi));
    q[j] = std::min(std::max(q[j], lower), upper);
  }

  // Other joints stay where they are in `q`.
  JointState drawn(const JointState& q) {
    JointState best = q;
    Scalar least = std::numeric_limits<Scalar>::infinity();
    for (int k = 0; k < kDrawn; ++k) {
      JointState here = q;
      for (int row = 0; row < kCount; ++row) {
        const int j = joint(row);
        Scalar lower = options_.lower[j], upper = options_.upper[j];
        if (!std::isfinite(lower)) lower = std::isfinite(upper) ? upper - 2 * kPi : -kPi;
        if (!std::isfinite(upper)) upper = lower + 2 * kPi;
        here[j] = lower + (upper - lower) * static_cast<Scalar>(uniform_());
      }
      const Scalar square = error(here).squaredNorm();
      if (square < least) least = square, best = here;
    }
    return best;
  }

  void descend(JointState here, InverseKinematicsResult<JointState>& best) {
    for (int step = 0;; ++step) {
      const Vector6 e = error(here);
      const Scalar largest = e.cwiseAbs().maxCoeff();
      if (largest < best.error) best.q = here, best.error = largest;
      best.found = best.error <= options_.tolerance;
      if (best.found || step == options_.steps) return;
      move(here, e);
      ++best.steps;
    }
  }

  // A joint at a limit that would leave it is held, and the step is computed again.
  void move(JointState& q, const Vector6& e) const {
    auto J = chain_.jacobian(q);
    J.template bottomRows<3>() /= options_.length;
    Joints step = damped(J, e);
    bool is_held = false;
    for (int row = 0; row < kCount; ++row) {
      const int j = joint(row);
      constexpr Scalar kAt = Scalar(1e-6);
      const bool leaves =
          (step[row] > 0 && q[j] >= options_.upper[j] - kAt) || (step[row] < 0 && q[j] <= options_.lower[j] + kAt);
      if (!leaves) continue;
      J.col(row).setZero();
      is_held = true;
    }
    if (is_held) step = damped(J, e);
    for (int row = 0; row < kCount; ++row) {
      q[joint(row)] += step[row];
      into_limits(q, joint(row));
    }
  }

  template <class Jacobian>
  Joints damped(const Jacobian& J, const Vector6& e) const {
    return Joints(damped_step<kCount>(J, e, options_.damping + e.squaredNorm() / 20).data());
  }
};

}  // namespace inverse_kinematics_detail

// Searches joint positions within limits at which chain.pose(q) is `target`: damped steps from q, then from other
// starts, each the best of some random positions. The number of steps is bounded. If the target is not reached, the
// result is the position with the least error that was met. The same arguments have the same result; joints outside the
// chain keep their positions. Where the chain has a closed form, the functions of the group `inverse_kinematics` find
// all solutions.
template <KinematicChain C>
InverseKinematicsResult<typename C::JointState> inverse_kinematics(
    const C& chain,
    const typename C::JointState& q,
    const Matrix<typename C::JointState::Scalar, 4, 4>& target,
    const InverseKinematicsOptions<typename C::JointState>& options = {}) noexcept {
  return inverse_kinematics_detail::Search<C>(chain, target, options).from(q);
}

}  // namespace robcogen

#else
#error "robcogen/generic/inverse_kinematics.h needs C++20: compile with -std=c++20"
#endif
