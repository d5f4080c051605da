// All positions of a chain of six joints for a pose, where the chain has no closed form but has one with a joint given:
// a search over that joint. Needs C++20.
//
//     robcogen_add_robot(TARGET arm … INVERSE_KINEMATICS fr_base:tool:given=J1)
//
//     struct Hand {                                                  // as for robcogen::inverse_kinematics
//       using JointState = arm::JointState;
//       static auto pose(const JointState& q) { return arm::transforms::homogeneous::fr_base_X_tool(q); }
//       static auto jacobian(const JointState& q) { return arm::jacobians::fr_base_J_tool(q); }
//       static constexpr auto kColumns = arm::jacobians::fr_base_J_tool_columns;
//       static constexpr auto kGiven = arm::Joint::J1;
//       static constexpr auto kJoints = arm::inverse_kinematics::fr_base_X_tool_joints;
//       static constexpr auto kTypes = arm::kJointTypes;
//       static auto branches(const Eigen::Matrix4d& X, const JointState& reference) {
//         return arm::inverse_kinematics::fr_base_X_tool(X, reference);
//       }
//     };
//     const auto all = robcogen::all_solutions(Hand(), X, q);        // all.q[0] … all.q[all.count - 1]
//
// Nothing allocates.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "robcogen/generic/inverse_kinematics.h"
#include "robcogen/inverse_kinematics.h"

namespace robcogen {

template <class C>
concept ChainWithGivenJoint = KinematicChain<C> &&
    requires(const C& chain, const typename C::JointState& q, const Matrix<typename C::JointState::Scalar, 4, 4>& X) {
  chain.branches(X, q).misfit;
  requires std::tuple_size_v<decltype(C::kJoints)>
  == C::kColumns.size();
  static_cast<int>(C::kGiven);
  C::kTypes[0];
};

// A chain of six joints that turn has 16 solutions at most.
template <class JointState>
struct Solutions {
  static constexpr int kMost = 16;
  std::array<JointState, kMost> q;  // angles from -pi to pi, but for rounding; other joints as in the reference
  int count = 0;
};

template <class Scalar>
struct SolutionsOptions {
  int samples = 512;                                                                   // of the given joint, at least 3
  Scalar lower = Scalar(-3.141592653589793238), upper = Scalar(3.141592653589793238);  // its range (rad, m)
  Scalar tolerance = std::is_same_v<Scalar, float> ? Scalar(1e-5) : Scalar(1e-9);      // of the pose (rad, m)
  int steps = 12;                                                                      // of each start
};

namespace inverse_kinematics_detail {

template <ChainWithGivenJoint C>
class AllSolutions {
 public:
  using JointState = typename C::JointState;
  using Scalar = typename JointState::Scalar;
  using Pose = Matrix<Scalar, 4, 4>;
  using Options = SolutionsOptions<Scalar>;

  AllSolutions(const C& chain, const Pose& target, const JointState& reference, const Options& options)
      : chain_(chain), target_(target), reference_(reference), options_(options) {}

  // Where the misfit of a branch is less than at the samples before and behind, a solution may be near. Two that are
  // nearer to each other than samples are found from both sides.
  Solutions<JointState> found() noexcept {
    Sample before = sample(-1), here = sample(0);
    for (int i = 0; i < options_.samples; ++i) {
      const Sample next = sample(i + 1);
      for (Eigen::Index branch = 0; branch < here.branches.misfit.size(); ++branch) {
        const Scalar least = here.branches.misfit[branch];
        if (!(least <= before.branches.misfit[branch] && least <= next.branches.misfit[branch])) continue;
        for (const Sample& start : {std::cref(here), std::cref(before), std::cref(next)})
          descend(start, static_cast<int>(branch));
      }
      before = here;
      here = next;
    }
    return solutions_;
  }

 private:
  using Branches =
      decltype(std::declval<const C&>().branches(std::declval<const Pose&>(), std::declval<const JointState&>()));
  struct Sample {
    JointState reference;
    Branches branches;
  };

  static constexpr int kGiven = static_cast<int>(C::kGiven);
  static constexpr Scalar kSame = Scalar(1e-4);  // rad, m: solutions that differ by less are one
  static constexpr Scalar kDamping = Scalar(1e-12);

  const C& chain_;
  const Pose& target_;
  const JointState& reference_;
  const Options& options_;
  Solutions<JointState> solutions_;

  static bool is_turning(int joint) { return C::kTypes[static_cast<std::size_t>(joint)] != JointType::prismatic; }

  Scalar range() const { return options_.upper - options_.lower; }
  bool is_circle() const { return is_turning(kGiven) && range() > kTurn<Scalar> - kSame; }

  // Samples of a whole turn are a circle; otherwise the first and the last are repeated.
  Sample sample(int i) const {
    const int last = options_.samples - 1;
    const Scalar spacing = range() / static_cast<Scalar>(is_circle() ? last + 1 : last);
    JointState reference = reference_;
    reference[kGiven] = options_.lower + spacing * static_cast<Scalar>(is_circle() ? i : std::clamp(i, 0, last));
    return {reference, chain_.branches(target_, reference)};
  }

  void descend(const Sample& start, int branch) {
    JointState q = branch_positions(start.branches, C::kJoints, C::kTypes, branch, start.reference);
    for (int step = 0;; ++step) {
      const Scalar error = pose_error<Scalar>(chain_.pose(q), target_).cwiseAbs().maxCoeff();
      if (error <= options_.tolerance) return add(q);
      if (step == options_.steps || !(error < kTurn<Scalar> * 100)) return;
      q = inverse_kinematics_step(chain_, q, target_, kDamping);
    }
  }

  bool is_in_range(Scalar given) const {
    Scalar d = given - options_.lower;
    if (is_turning(kGiven)) d -= kTurn<Scalar> * std::floor((d + kSame) / kTurn<Scalar>);
    return is_circle() || (d >= -kSame && d <= range() + kSame);
  }

  void add(JointState q) {
    if (!is_in_range(q[kGiven])) return;
    for (const auto joint : C::kJoints)
      if (const int j = static_cast<int>(joint); is_turning(j)) q[j] = std::remainder(q[j], kTurn<Scalar>);
    for (int k = 0; k < solutions_.count; ++k)
      if (are_same(q, solutions_.q[static_cast<std::size_t>(k)])) return;
    if (solutions_.count < Solutions<JointState>::kMost) solutions_.q[static_cast<std::size_t>(solutions_.count++)] = q;
  }

  static bool are_same(const JointState& a, const JointState& b) {
    for (const auto joint : C::kJoints) {
      const int j = static_cast<int>(joint);
      const Scalar d = a[j] - b[j];
      if (std::abs(is_turning(j) ? std::remainder(d, kTurn<Scalar>) : d) > kSame) return false;
    }
    return true;
  }
};

}  // namespace inverse_kinematics_detail

// The positions at which chain.pose(q) is `target`. Few solutions are missed: those in which the chain is almost
// singular, and those that lie between samples next to another one.
template <ChainWithGivenJoint C>
Solutions<typename C::JointState> all_solutions(
    const C& chain,
    const Matrix<typename C::JointState::Scalar, 4, 4>& target,
    const typename C::JointState& reference,
    const SolutionsOptions<typename C::JointState::Scalar>& options = {}) noexcept {
  return inverse_kinematics_detail::AllSolutions<C>(chain, target, reference, options).found();
}

}  // namespace robcogen

#else
#error "robcogen/generic/all_solutions.h needs C++20: compile with -std=c++20"
#endif
