#include "algorithm/kinematics/inverse/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithm/kinematics/inverse/laboratory.h"
#include "algorithm/kinematics/inverse/swivel.h"

namespace robcogen::algorithm::inversion {
namespace {

constexpr int kFewest = 2, kMost = 5;

// By joint of the chain as it is.
JointValues of_chain(const Calibration& calibration, const JointValues& of_plan) {
  JointValues values(calibration.chain.axes.size());
  for (std::size_t k = 0; k < calibration.places.size(); ++k) values[k] = of_plan[at(calibration.places[k])];
  return values;
}

JointValues of_plan(const Calibration& calibration, const JointValues& of_chain) {
  JointValues values(calibration.chain.axes.size());
  for (std::size_t k = 0; k < calibration.places.size(); ++k) values[at(calibration.places[k])] = of_chain[k];
  return values;
}

// The joints of arranged chains are the same in another order (arrangements.h).
std::vector<int> places_of(const SerialChain& chain, const SerialChain& of_plan) {
  std::vector<int> places;
  for (int k = 0; k < chain.joints; ++k) {
    const auto is_same = [&](const ChainAxis& a) {
      return a.joint == chain.axis(k).joint && a.amount == chain.axis(k).amount;
    };
    const auto place = std::find_if(of_plan.axes.begin(), of_plan.axes.end(), is_same);
    places.push_back(static_cast<int>(place - of_plan.axes.begin()));
  }
  return places;
}

// Before any step.
std::vector<Branch> nominal_branches(Laboratory& lab, const Search& found, const Expression& swivel, double margin) {
  if (found.swivel)
    return swivel_branches(lab.graph, *found.swivel, lab.target, lab.references, swivel, nullptr, margin);
  const Plan& plan = *found.plan;
  StepSolver solver(lab.graph, plan.chain, lab.target, lab.references, plan.lengths_agree, margin);
  return branches(lab.graph, solver, plan.chain, plan.steps, lab.known());
}

// The shares of random positions that a branch has, after kFewest, …, kMost steps.
std::vector<double> shares(const Calibration& calibration, const Search& found) {
  constexpr double kSamePose = 1e-9, kSamePosition = 1e-6;
  constexpr int kRounds = 40;
  const SerialChain& nominal = found.chain;
  Laboratory lab(nominal);
  Expression swivel;
  if (found.swivel) swivel = swivel_of(lab.graph, *found.swivel, {lab.joints.begin(), lab.joints.end()});
  const NewtonSteps newton = newton_steps(lab.graph, calibration, found, lab.target, swivel);
  std::vector<std::vector<RefinedBranch>> after;  // by number of steps and branch; values by joint of the chain
  for (const Branch& branch : nominal_branches(lab, found, swivel, calibration.margin)) {
    JointValues values = of_chain(calibration, branch.values);
    for (int step = 1; step <= kMost; ++step) {
      values = newton.step(values);
      if (step < kFewest) continue;
      after.resize(std::max(after.size(), at(step - kFewest + 1)));
      after[at(step - kFewest)].push_back({values, newton.misfit(values)});
    }
  }
  std::vector<double> result(after.size());
  Random random(11);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<std::vector<SineCosine>> expected;  // by state
    for (std::size_t state = 0; state < kProbes; ++state) {
      const std::vector<double> q = random_positions(nominal, random, false);
      const std::vector<SineCosine> of_joints = sines_cosines(nominal, q);
      std::vector<SineCosine>& own = expected.emplace_back();
      for (const int place : calibration.places) own.push_back(of_joints[at(place)]);
      lab.set(state, pose(calibration.chain, own), q);
    }
    Probes probes(lab.graph, lab.inputs);
    for (std::size_t count = 0; count < after.size(); ++count) {
      std::array<bool, kProbes> is_found{};
      for (const RefinedBranch& branch : after[count]) {
        ProbeValues distance{};
        for (int k = 0; k < calibration.chain.joints; ++k) {
          const ProbeValues sine = probes(branch.values[at(k)]->sine), cosine = probes(branch.values[at(k)]->cosine);
          for (std::size_t state = 0; state < kProbes; ++state) {
            const SineCosine& own = expected[state][at(k)];
            distance[state] += std::hypot(sine[state] - own.sine, cosine[state] - own.cosine);
          }
        }
        const ProbeValues misfit = probes(branch.misfit);
        for (std::size_t state = 0; state < kProbes; ++state)
          is_found[state] = is_found[state] || (misfit[state] < kSamePose && distance[state] < kSamePosition);
      }
      result[count] += static_cast<double>(std::count(is_found.begin(), is_found.end(), true)) / (kRounds * kProbes);
    }
  }
  return result;
}

}  // namespace

Calibration calibration(const SerialChain& chain, const NominalChain& nominal, const Search& found) {
  constexpr double kWorthAStep = 0.01;
  Calibration result{chain, places_of(chain, found.chain), nominal.angle, nominal.distance};
  // About as much as the discriminants of the nominal chain are off.
  result.margin = 2.0 * std::max(nominal.angle, nominal.distance * kSameDirection / chain.same_point);
  const std::vector<double> share = shares(result, found);
  std::size_t best = 0;
  while (best + 1 < share.size() && share[best + 1] > share[best] + kWorthAStep) ++best;
  result.steps = kFewest + static_cast<int>(best);
  result.share = share[best];
  return result;
}

NewtonSteps newton_steps(
    Graph& graph,
    const Calibration& calibration,
    const Search& found,
    const Target& target,
    const Expression& swivel) {
  if (!found.swivel) return {graph, calibration.chain, target};
  // A chain with a swivel angle is not arranged.
  const auto condition = [&graph, plan = found.swivel, swivel](const JointValues& values) {
    return swivel_condition(graph, *plan, swivel, values);
  };
  return {graph, calibration.chain, target, condition};
}

RefinedBranch refined(const Calibration& calibration, const NewtonSteps& newton, const JointValues& values) {
  JointValues here = of_chain(calibration, values);
  for (int step = 0; step < calibration.steps; ++step) here = newton.step(here);
  return {of_plan(calibration, here), newton.misfit(here)};
}

}  // namespace robcogen::algorithm::inversion
