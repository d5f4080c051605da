// Chains whose axes are slightly off, so that no equation in one unknown holds exactly: the plan of a nominal chain,
// and Newton steps on the chain itself.
#pragma once

#include <vector>

#include "algorithm/kinematics/inverse/newton.h"
#include "algorithm/kinematics/inverse/nominal.h"
#include "algorithm/kinematics/inverse/plan.h"

namespace robcogen::algorithm::inversion {

struct Calibration {
  SerialChain chain;                   // as it is
  std::vector<int> places;             // of its joints in the chain of the plan
  double angle = 0.0, distance = 0.0;  // the largest differences between its axes and nominal ones (rad, m)
  double margin = 0.0;                 // of discriminants (step_solver.h)
  int steps = 0;                       // more of them would hardly find more positions
  double share = 0.0;                  // of random positions that a branch has after these steps
};

// Of a chain, with what the search has found for its nominal chain: a plan, or the swivel angle's.
Calibration calibration(const SerialChain& chain, const NominalChain& nominal, const Search& found);

// Towards a target; with this swivel angle of the nominal chain, if the plan has one.
NewtonSteps newton_steps(
    Graph& graph,
    const Calibration& calibration,
    const Search& found,
    const Target& target,
    const Expression& swivel);

// A branch of the plan, after all steps.
struct RefinedBranch {
  JointValues values;  // by joint of the plan
  Expression misfit;
};
RefinedBranch refined(const Calibration& calibration, const NewtonSteps& newton, const JointValues& values);

}  // namespace robcogen::algorithm::inversion
