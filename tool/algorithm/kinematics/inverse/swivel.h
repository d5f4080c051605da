// Arms of seven joints whose first three axes meet in a shoulder and whose last three in a wrist: the swivel angle, by
// which the plane of shoulder, elbow and wrist is turned about the line from shoulder to wrist, is an argument (Elias,
// Wen, arXiv:2307.13122). It is measured at the axis of the fourth joint, so that a stretched arm is regular; it is
// undefined where the line is parallel to the first axis.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithm/kinematics/inverse/newton.h"
#include "algorithm/kinematics/inverse/plan.h"

namespace robcogen::algorithm::inversion {

struct SwivelPlan {
  SerialChain chain;
  Numbers3 shoulder_point{}, wrist_point{};
  Step elbow;            // from the distance of both points
  Plan shoulder, wrist;  // from the orientations behind the third joint and behind the last one
  Closure closure;       // which tells whether a branch has the pose

  int roots() const { return 1 + shoulder.roots() + wrist.roots(); }
  int branches() const { return 1 << roots(); }
  // The joints that are found, with two roots or one.
  std::vector<std::string> lines() const;
  // The joints to which signs belong, in this order.
  std::vector<std::string> sign_names() const;
};

// nullopt if the arm is of another kind.
std::optional<SwivelPlan> swivel_plan(const SerialChain& chain);

// All branches, or that with these signs. `references` by joint of the chain; `margin` as for a StepSolver.
std::vector<Branch> swivel_branches(
    Graph& graph,
    const SwivelPlan& plan,
    const Target& target,
    const std::vector<Expression>& references,
    const Expression& swivel,
    const std::vector<Expression>* signs,
    double margin = 0.0);

// At these positions: the swivel angle, and the roots with their signs.
Expression swivel_of(Graph& graph, const SwivelPlan& plan, const JointValues& values);
// That the swivel angle of these positions is `swivel`: the sine of what is missing, and derivatives, times the sine of
// the angle between the first axis and the line.
Condition swivel_condition(Graph& graph, const SwivelPlan& plan, const Expression& swivel, const JointValues& values);
std::vector<Expression> swivel_roots(
    Graph& graph,
    const SwivelPlan& plan,
    const std::vector<Expression>& references,
    const JointValues& values);

}  // namespace robcogen::algorithm::inversion
