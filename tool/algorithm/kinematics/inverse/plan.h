// Plans: an order in which all joints of a chain are found, each by an equation in one unknown.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithm/kinematics/inverse/closure.h"
#include "algorithm/kinematics/inverse/step_solver.h"

namespace robcogen::algorithm::inversion {

struct Plan {
  SerialChain chain;
  std::vector<Step> steps;
  std::vector<bool> lengths_agree = {};  // StepSolver
  Closure closure = {};                  // which tells whether a branch has the pose
  // The product of the roots, times this number, is the determinant of the Jacobian; zero if it is not, for some
  // chains.
  double determinant_per_root = 0.0;

  int roots() const;  // steps with two roots: the number of signs
  int branches() const { return 1 << roots(); }
};

struct SwivelPlan;   // swivel.h
struct Calibration;  // calibration.h

struct Search {
  std::optional<Plan> plan;
  SerialChain chain;
  Known found;                                          // the joints that are found, if not all are
  std::shared_ptr<const SwivelPlan> swivel = {};        // instead of a plan, if the task takes the swivel angle
  std::shared_ptr<const Calibration> calibration = {};  // of a plan for a nominal chain, which `chain` is then
};

// The cheapest of the most accurate plans that the search finds. It is the same on all machines.
Search search(const SerialChain& chain);

// The same for the chain of frames without obstacle, or for its nominal chain if it has no plan and the task has a
// tolerance; searched once for all calls with the same numbers.
const Search& search(const model::KinematicTree& tree, const model::FramePair& frames, const model::InverseTask& task);

struct Branch {
  JointValues values;
  Expression product;  // of the roots
};

// Solves all steps: with both signs in turn, or with these signs. `values`: given joints. Empty if a step cannot find
// its joint.
std::vector<Branch> branches(
    Graph& graph,
    StepSolver& solver,
    const SerialChain& chain,
    const std::vector<Step>& steps,
    const JointValues& given,
    const std::vector<Expression>* signs = nullptr);

}  // namespace robcogen::algorithm::inversion
