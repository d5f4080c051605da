// The equation of a step, solved with expressions.
#pragma once

#include <optional>
#include <vector>

#include "algorithm/kinematics/inverse/target_loop.h"

namespace robcogen::algorithm::inversion {

struct SolvedJoint {
  JointValue value;
  Expression root;  // that the sign multiplies, with the sign; zero where both roots meet
};

class StepSolver {
 public:
  // `references`: positions by joint of the chain, for joints that have no effect. `lengths_agree`, by joint: whether
  // the vectors of a vector step have equal lengths across the axis, whatever the target. `margin`: discriminants,
  // relative to their largest values, are at least half of this. Roots of a nominal chain are not then where two of
  // them meet, where Newton steps towards those of the chain itself have no direction.
  StepSolver(
      Graph& graph,
      const SerialChain& chain,
      Target target,
      std::vector<Expression> references,
      std::vector<bool> lengths_agree = {},
      double margin = 0.0);

  // The joint of a step, with this sign (1 or -1) of the root if it has two. nullopt if the step cannot find it.
  std::optional<SolvedJoint> solve(const Step& step, const JointValues& values, const Expression& sign);

  // The root of a step with two, with its sign, at known positions of all joints.
  Expression root(const Step& step, const JointValues& values) const;

  const TargetLoop& loop() const { return loop_; }

  // By vector step that was solved: the squared lengths of its vectors across the axis.
  struct Lengths {
    int joint;
    Expression a, b;
  };
  const std::vector<Lengths>& lengths() const { return lengths_; }

 private:
  using Item = TargetLoop::Item;
  using Sides = TargetLoop::Sides;
  using Basis = TargetLoop::Basis;

  // A discriminant whose terms are small where axes align: lengths - k^2.
  struct Discriminant {
    Expression lengths, k;
  };

  Graph& graph_;
  const SerialChain& chain_;
  TargetLoop loop_;
  std::vector<Expression> references_;
  std::vector<bool> lengths_agree_;
  double margin_;
  Expression tiny_;  // 2^-59 to 2^-58
  std::vector<Lengths> lengths_;

  // The discriminant, or zero if it is negative; the margin counts for this largest value of it.
  Expression positive(const Expression& discriminant, const Expression& largest) const;
  std::optional<SolvedJoint> two_roots(
      int joint,
      const Vector3& left,
      const Vector3& right,
      const Expression& value,
      const Expression& sign,
      const std::optional<Discriminant>& discriminant);
  std::optional<SolvedJoint> turned(int joint, const Vector3& from, const Vector3& to, bool is_backward);
  std::optional<SolvedJoint> solved(const Step& step, const JointValues& values, const Expression& sign);
  std::optional<SolvedJoint> by_vector(const Step& step, const JointValues& values);
  std::optional<SolvedJoint> by_angle(const Step& step, const JointValues& values, const Expression& sign);
  std::optional<SolvedJoint> by_distance(const Step& step, const JointValues& values, const Expression& sign);
  std::optional<SolvedJoint> by_height(const Step& step, const JointValues& values, const Expression& sign);
  std::optional<SolvedJoint> at_meeting_axes(
      const Step& step,
      const JointValues& values,
      const Expression& sign,
      const Numbers3& meeting);
  Discriminant of_aligned(
      int joint,
      const Vector3& a,
      const Vector3& b,
      const Vector3& a_far,
      const Vector3& b_far,
      const Expression& value) const;
};

}  // namespace robcogen::algorithm::inversion
