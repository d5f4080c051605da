// By how much a branch misses its target. Where two solutions meet, an equation that holds up to rounding leaves an
// error of the square root of rounding; so the equations of the steps do not tell whether a branch has the pose.
// Features of one link do, seen both ways around the loop of chain and target.
#pragma once

#include <vector>

#include "algorithm/kinematics/inverse/target_loop.h"

namespace robcogen::algorithm::inversion {

struct Closure {
  // Seen from the link before the joint `cut`. Most of what this takes is known from the steps.
  struct Item {
    Feature feature;
    int cut;
  };
  std::vector<Item> points, directions;
  // The error of the pose is at most the root of 1 + reach^2 times the length of the differences, those of directions
  // times this. The reach is the largest distance of the last frame from the point, without these joints that slide.
  double reach = 0.0, direction_weight = 1.0;
  std::vector<int> slides = {};
};

// The cheapest one for these branches, with the values of all joints.
Closure cheapest_closure(
    Graph& graph,
    const TargetLoop& loop,
    const SerialChain& chain,
    const std::vector<JointValues>& branches);

// At least the error of the branch's pose: the distance (m) and the angle (rad, as a chord).
Expression misfit(Graph& graph, const TargetLoop& loop, const Closure& closure, const JointValues& values);

}  // namespace robcogen::algorithm::inversion
