#include "algorithm/search/forward_dynamics_choice.h"

#include "algorithm/search/frame_search.h"
#include "support/index.h"
#include "symbolic/accuracy.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm {
namespace {

const std::string kName = "forward_dynamics";

// Elimination alone takes half a product and sum for each pair of ancestors of a joint, articulated bodies about a
// hundred instructions per joint. Elimination is cubic in the depth of the tree: if it cannot win, it is not traced.
bool is_elimination_cheap(const model::KinematicTree& tree) {
  constexpr long kInstructionsOfJoint = 100;
  std::vector<long> depth(tree.joints.size());
  long pairs = 0;
  for (const int j : tree.topological()) {
    const int parent = tree.parent_joint_of(j);
    depth[at(j)] = parent < 0 ? (tree.floating_base ? 6 : 0) : depth[at(parent)] + 1;
    pairs += depth[at(j)] * depth[at(j)];
  }
  return pairs / 2 < kInstructionsOfJoint * tree.dof();
}

}  // namespace

ForwardDynamicsChoice forward_dynamics_choice(const model::KinematicTree& tree, const Formulation& formulation) {
  const Loads loads = default_loads(tree);
  const auto cheapest = [&](ForwardDynamicsMethod method) {
    const auto trace_of = [&](Trace& trace, const Formulation& tried) {
      trace_forward_dynamics(trace, loads, {method, tried});
    };
    ForwardDynamicsChoice choice{method, formulation};
    choice.formulation.frames = cheap_frames(tree, formulation, trace_of);
    return choice;
  };
  const auto time = [&](const ForwardDynamicsChoice& choice) {
    return symbolic::predicted_time(forward_dynamics(tree, kName, loads, choice));
  };
  if (!allows_articulated_bodies(tree)) return cheapest(ForwardDynamicsMethod::inertia_matrix);
  ForwardDynamicsChoice bodies = cheapest(ForwardDynamicsMethod::articulated_bodies);
  if (!formulation.choose_forward_dynamics || !is_elimination_cheap(tree)) return bodies;
  ForwardDynamicsChoice matrix = cheapest(ForwardDynamicsMethod::inertia_matrix);
  if (time(matrix) >= time(bodies)) return bodies;
  Formulation plain = plain_formulation();
  plain.is_draft = true;
  const symbolic::AccurateResults results(
      forward_dynamics(tree, kName, loads, {ForwardDynamicsMethod::articulated_bodies, plain}), parameter_values(tree));
  matrix.formulation.is_draft = true;
  const bool keeps_digits = results.are_kept_by(forward_dynamics(tree, kName, loads, matrix));
  matrix.formulation.is_draft = false;
  return keeps_digits ? matrix : bodies;
}

symbolic::Program forward_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  return forward_dynamics(tree, name, loads, forward_dynamics_choice(tree, formulation));
}

}  // namespace robcogen::algorithm
