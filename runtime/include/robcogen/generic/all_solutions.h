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
//
// With the kernels of these functions, the search is several times as fast; <arm/kernel/…h> have them:
//
//       template <class S>
//       static void branches(const S* X, const S* reference, S* sin_q, S* cos_q, S* misfit, S* determinant) {
//         arm::kernel::inverse_kinematics_fr_base_X_tool(X, reference, sin_q, cos_q, misfit, determinant);
//       }
//       template <class S>
//       static void pose(const S* q, S* X) { arm::kernel::homogeneous_fr_base_X_tool(q, X); }
//       template <class S>
//       static void jacobian(const S* q, S* J) { arm::kernel::fr_base_J_tool(q, J); }
//
//     const auto all = robcogen::all_solutions(Hand(), X, q);        // all.q[0] … all.q[all.count - 1]
//
// Nothing allocates.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "robcogen/generic/inverse_kinematics.h"
#include "robcogen/inverse_kinematics.h"
#include "robcogen/lanes.h"

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

// A chain that also has kernels, for any type of numbers.
template <class C>
concept ChainWithKernels = ChainWithGivenJoint<C> && requires(
    const C& chain,
    const Lanes<typename C::JointState::Scalar, 4>* in,
    Lanes<typename C::JointState::Scalar, 4>* out) {
  chain.branches(in, in, out, out, out, out);
  chain.pose(in, out);
  chain.jacobian(in, out);
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
namespace {  // separate in each file, like lanes

// A search takes samples, and steps from several starts, in lanes. Without kernels, functions of the chain are called
// for one lane after the other.
template <ChainWithGivenJoint C>
class AllSolutions {
 public:
  using JointState = typename C::JointState;
  using Scalar = typename JointState::Scalar;
  using Pose = Matrix<Scalar, 4, 4>;
  using Options = SolutionsOptions<Scalar>;

  AllSolutions(const C& chain, const Pose& target, const JointState& reference, const Options& options)
      : chain_(chain), target_(target), reference_(reference), options_(options) {
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) target_lanes_[row + 4 * column] = Numbers(target(row, column));
    for (int lane = 0; lane < kLanes; ++lane) steps_[lane] = kFree;
  }

  // Samples from -1 to their number: those of a whole turn are a circle.
  Solutions<JointState> found() noexcept {
    Block blocks[2];
    for (int i = 0, first = -1; first <= options_.samples; ++i, first += kLanes) {
      const Block &before = blocks[(i + 1) % 2], &here = blocks[i % 2];
      sample(first, blocks[i % 2]);
      const int begin = i == 0 ? 1 : -1, end = std::min(kLanes - 1, options_.samples - first);
      for (int k = begin; k < end; ++k)
        for (int branch = 0; branch < kBranches; ++branch) look(before, here, k, branch);
    }
    while (busy_ > 0) step();
    return solutions_;
  }

 private:
  static constexpr bool kHasKernels = ChainWithKernels<C>;
  static constexpr int kLanes = std::max(4, lanes::kInRegister<Scalar>);
  using Numbers = Lanes<Scalar, kLanes>;
  using Branches =
      decltype(std::declval<const C&>().branches(std::declval<const Pose&>(), std::declval<const JointState&>()));

  static constexpr int kGiven = static_cast<int>(C::kGiven);
  static constexpr int kDof = JointState::RowsAtCompileTime;
  static constexpr int kRows = static_cast<int>(std::tuple_size_v<decltype(C::kJoints)>);
  static constexpr int kBranches = decltype(Branches::misfit)::SizeAtCompileTime;
  static constexpr int kFree = -1;
  static constexpr Scalar kSame = Scalar(1e-4);  // rad, m: solutions that differ by less are one
  static constexpr Scalar kDamping = Scalar(1e-12);
  static constexpr Scalar kLinear = Scalar(0.01);  // by how much a misfit that grows in proportion is off

  // A sample in each lane. Rows of a branch are neighbours, as generated functions return them.
  struct Block {
    Scalar given[kLanes];
    Numbers misfit[kBranches], sine[kBranches * kRows], cosine[kBranches * kRows];
  };
  // Of a Jacobian with six rows, in lanes.
  struct Jacobian {
    Numbers elements[6 * kRows];
    const Numbers& operator()(int row, int column) const { return elements[row + 6 * column]; }
  };

  const C& chain_;
  const Pose& target_;
  const JointState& reference_;
  const Options& options_;
  Numbers target_lanes_[16];
  Solutions<JointState> solutions_;
  Scalar q_[kDof][kLanes] = {};  // of starts that take steps
  int steps_[kLanes];            // that each has taken; or the lane is free
  int busy_ = 0;                 // lanes

  static bool is_turning(int joint) { return C::kTypes[static_cast<std::size_t>(joint)] != JointType::prismatic; }
  static int joint_of(int row) { return static_cast<int>(C::kJoints[static_cast<std::size_t>(row)]); }

  Scalar range() const { return options_.upper - options_.lower; }
  bool is_circle() const { return is_turning(kGiven) && range() > kTurn<Scalar> - kSame; }

  // The position of the given joint in a sample. If samples do not form a circle, the first and the last are repeated.
  Scalar given(int i) const {
    const int last = options_.samples - 1;
    const Scalar spacing = range() / static_cast<Scalar>(is_circle() ? last + 1 : last);
    return options_.lower + spacing * static_cast<Scalar>(is_circle() ? i : std::clamp(i, 0, last));
  }

  void sample(int first, Block& block) const {
    for (int lane = 0; lane < kLanes; ++lane) block.given[lane] = given(first + lane);
    if constexpr (kHasKernels) {
      Numbers reference[kDof], determinant[kBranches];
      for (int k = 0; k < kDof; ++k) reference[k] = Numbers(reference_[k]);
      reference[kGiven] = Numbers::load(block.given);
      chain_.branches(target_lanes_, reference, block.sine, block.cosine, block.misfit, determinant);
    } else {
      Scalar numbers[2 * kRows + 1][kBranches][kLanes];
      for (int lane = 0; lane < kLanes; ++lane) {
        JointState reference = reference_;
        reference[kGiven] = block.given[lane];
        const Branches branches = chain_.branches(target_, reference);
        for (int branch = 0; branch < kBranches; ++branch) {
          for (int row = 0; row < kRows; ++row) {
            numbers[row][branch][lane] = branches.sin_q(row, branch);
            numbers[kRows + row][branch][lane] = branches.cos_q(row, branch);
          }
          numbers[2 * kRows][branch][lane] = branches.misfit[branch];
        }
      }
      for (int branch = 0; branch < kBranches; ++branch) {
        for (int row = 0; row < kRows; ++row) {
          block.sine[kRows * branch + row] = Numbers::load(numbers[row][branch]);
          block.cosine[kRows * branch + row] = Numbers::load(numbers[kRows + row][branch]);
        }
        block.misfit[branch] = Numbers::load(numbers[2 * kRows][branch]);
      }
    }
  }

  // Lane k of a block, or of the block before it.
  static Scalar lane_of(const Numbers& before, const Numbers& here, int k) {
    return k < 0 ? before[k + kLanes] : here[k];
  }

  // Where the misfit of a branch is less than at the samples before and behind, a solution may be near. If it is zero
  // once, it grows from there in proportion. Two solutions that are nearer to each other than samples are found from
  // both sides.
  void look(const Block& before, const Block& here, int k, int branch) {
    const auto misfit = [&](int at) { return lane_of(before.misfit[branch], here.misfit[branch], at); };
    const Scalar least = misfit(k), last = misfit(k - 1), next = misfit(k + 1);
    if (!(least <= last && least <= next)) return;
    const Scalar most = std::max(last, next), other = std::min(last, next);
    start(before, here, k, branch);
    if (std::abs(most - other - 2 * least) < kLinear * most) return;
    start(before, here, k - 1, branch);
    start(before, here, k + 1, branch);
  }

  void start(const Block& before, const Block& here, int k, int branch) {
    while (busy_ == kLanes) step();
    int lane = 0;
    while (steps_[lane] != kFree) ++lane;
    Scalar sine[kRows], cosine[kRows], angle[kRows];
    for (int row = 0; row < kRows; ++row) {
      const int i = kRows * branch + row;
      sine[row] = lane_of(before.sine[i], here.sine[i], k);
      cosine[row] = lane_of(before.cosine[i], here.cosine[i], k);
    }
    arc_tangents_of<kRows>(sine, cosine, angle);
    for (int j = 0; j < kDof; ++j) q_[j][lane] = reference_[j];
    for (int row = 0; row < kRows; ++row) q_[joint_of(row)][lane] = is_turning(joint_of(row)) ? angle[row] : sine[row];
    q_[kGiven][lane] = k < 0 ? before.given[k + kLanes] : here.given[k];
    steps_[lane] = 0;
    ++busy_;
  }

  // One step in all lanes, as inverse_kinematics_step takes it. A lane whose pose is right, or that has no more steps,
  // is free then.
  void step() {
    Numbers q[kDof], X[16], e[6];
    Jacobian J;
    for (int j = 0; j < kDof; ++j) q[j] = Numbers::load(q_[j]);
    if constexpr (kHasKernels) {
      chain_.pose(q, X);
      chain_.jacobian(q, J.elements);
    } else {
      call_for_lanes(X, J);
    }
    pose_error(X, e);
    Numbers square = e[0] * e[0];
    for (int i = 1; i < 6; ++i) square = square + e[i] * e[i];
    const std::array<Numbers, kRows> change =
        damped_step<kRows>(J, e, Numbers(kDamping) + Numbers(Scalar(0.5)) * square);
    Scalar error[kLanes] = {};
    for (int i = 0; i < 6; ++i)
      for (int lane = 0; lane < kLanes; ++lane) {
        const Scalar of_element = std::abs(e[i][lane]);
        if (!(of_element <= error[lane])) error[lane] = of_element;  // also where it is NaN
      }
    for (int lane = 0; lane < kLanes; ++lane) {
      if (steps_[lane] == kFree) continue;
      if (error[lane] <= options_.tolerance) add(lane);
      if (error[lane] <= options_.tolerance || steps_[lane] == options_.steps || !(error[lane] < kTurn<Scalar> * 100)) {
        steps_[lane] = kFree;
        --busy_;
        continue;
      }
      ++steps_[lane];
      for (int row = 0; row < kRows; ++row) q_[joint_of(row)][lane] += change[static_cast<std::size_t>(row)][lane];
    }
  }

  JointState state(int lane) const {
    JointState q;
    for (int j = 0; j < kDof; ++j) q[j] = q_[j][lane];
    return q;
  }

  void call_for_lanes(Numbers* X, Jacobian& J) const {
    Scalar poses[16][kLanes], jacobians[6 * kRows][kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      const JointState q = state(lane);
      const auto pose = chain_.pose(q);
      const auto jacobian = chain_.jacobian(q);
      for (int i = 0; i < 16; ++i) poses[i][lane] = pose(i % 4, i / 4);
      for (int i = 0; i < 6 * kRows; ++i) jacobians[i][lane] = jacobian(i % 6, i / 6);
    }
    for (int i = 0; i < 16; ++i) X[i] = Numbers::load(poses[i]);
    for (int i = 0; i < 6 * kRows; ++i) J.elements[i] = Numbers::load(jacobians[i]);
  }

  // As the function for one pose: the axis times the angle of the rotation to the target, and the displacement.
  void pose_error(const Numbers* X, Numbers* e) const {
    constexpr Scalar kTiny = std::is_same_v<Scalar, float> ? Scalar(1e-36) : Scalar(1e-300);
    const Numbers half = Numbers(Scalar(0.5));
    Numbers trace = Numbers(Scalar(-1));
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      e[i] = Numbers(Scalar(0));
      for (int column = 0; column < 12; column += 4) {
        const Numbers *from = X + column, *to = target_lanes_ + column;
        e[i] = e[i] + half * (from[j] * to[k] - from[k] * to[j]);
        trace = trace + from[i] * to[i];
      }
      e[3 + i] = target_lanes_[12 + i] - X[12 + i];
    }
    const Numbers sine = sqrt(e[0] * e[0] + (e[1] * e[1] + e[2] * e[2]) + Numbers(kTiny));
    const Numbers factor = atan2(sine, half * trace) / sine;
    for (int i = 0; i < 3; ++i) e[i] = factor * e[i];
  }

  bool is_in_range(Scalar given) const {
    Scalar d = given - options_.lower;
    if (is_turning(kGiven)) d -= kTurn<Scalar> * std::floor((d + kSame) / kTurn<Scalar>);
    return is_circle() || (d >= -kSame && d <= range() + kSame);
  }

  void add(int lane) {
    JointState q = state(lane);
    if (!is_in_range(q[kGiven])) return;
    for (int row = 0; row < kRows; ++row)
      if (const int j = joint_of(row); is_turning(j)) q[j] = std::remainder(q[j], kTurn<Scalar>);
    for (int k = 0; k < solutions_.count; ++k)
      if (are_same(q, solutions_.q[static_cast<std::size_t>(k)])) return;
    if (solutions_.count < Solutions<JointState>::kMost) solutions_.q[static_cast<std::size_t>(solutions_.count++)] = q;
  }

  static bool are_same(const JointState& a, const JointState& b) {
    for (int row = 0; row < kRows; ++row) {
      const int j = joint_of(row);
      const Scalar d = a[j] - b[j];
      if (std::abs(is_turning(j) ? std::remainder(d, kTurn<Scalar>) : d) > kSame) return false;
    }
    return true;
  }
};

}  // namespace
}  // namespace inverse_kinematics_detail

namespace {

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

}  // namespace
}  // namespace robcogen

#else
#error "robcogen/generic/all_solutions.h needs C++20: compile with -std=c++20"
#endif
