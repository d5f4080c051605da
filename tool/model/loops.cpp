#include "model/loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "model/declare_loops.h"
#include "model/formula_closures.h"
#include "model/iterative_closure.h"
#include "model/parallelogram.h"
#include "model/plausibility.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

LoopContext context_of(const Description& description, KinematicTree& tree, Diagnostics& diagnostics) {
  LoopContext context{tree, diagnostics, {}, {}, {}, description.assembled_form};
  for (const Parameter& p : tree.parameters) context.parameters.push_back(p.default_value.value_or(1.0));
  for (const std::string& name : description.driven)
    if (const auto joint = tree.find_joint(name)) context.driven.insert(*joint);
  for (const Coupling& coupling : tree.couplings) {
    context.given.insert(coupling.joint);
    for (const Coupling::Term& term : coupling.terms) context.given.insert(term.joint);
  }
  return context;
}

// Refuses spherical joints in loops: each is still a single joint here, but will become three components.
void report_spherical_joints(LoopContext& context) {
  for (const LoopJoint& loop : context.tree.loops)
    for (const int joint : joints_of(loop))
      if (context.tree.joints[at(joint)].type == JointType::spherical)
        context.diagnostics
            .error(
                "loop-spherical", loop.place,
                fmt::format("spherical joint '{}' cannot be part of loop '{}'", context.name(joint), loop.name))
            .hint =
            "for a rod with a ball joint at each end, write a 'u_joint' at one end, which keeps it from spinning, and "
            "a loop with 'type = point' at the other; for a massless rod, write a loop with a 'distance'";
}

// Groups the loops that share joints, directly or through other loops.
std::vector<std::vector<int>> connected_loops(const KinematicTree& tree) {
  std::vector<std::vector<int>> groups;
  std::vector<std::set<int>> joints;  // by group
  for (std::size_t k = 0; k < tree.loops.size(); ++k) {
    const std::vector<int> own = joints_of(tree.loops[k]);
    std::vector<int> group = {static_cast<int>(k)};
    std::set<int> of_group(own.begin(), own.end());
    for (std::size_t g = groups.size(); g-- > 0;) {
      if (std::none_of(own.begin(), own.end(), [&](int joint) { return joints[g].contains(joint); })) continue;
      group.insert(group.begin(), groups[g].begin(), groups[g].end());
      of_group.insert(joints[g].begin(), joints[g].end());
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(g));
      joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(g));
    }
    groups.push_back(std::move(group));
    joints.push_back(std::move(of_group));
  }
  for (std::vector<int>& group : groups) std::sort(group.begin(), group.end());
  std::sort(groups.begin(), groups.end());
  return groups;
}

// Adds the closures that formulas give, in an order in which they can be solved. Returns the groups of loops without
// formulas.
std::vector<std::vector<int>> add_formula_closures(LoopContext& context) {
  std::vector<std::vector<int>> others;
  for (const std::vector<int>& loops : connected_loops(context.tree)) {
    if (std::optional<std::vector<Closure>> found = formula_closures(context, loops))
      std::move(found->begin(), found->end(), std::back_inserter(context.tree.closures));
    else
      others.push_back(loops);
  }
  return others;
}

// Returns the positions of all joints where loops are assembled.
std::vector<double> assemble(LoopContext& context, const std::vector<std::vector<int>>& without_formulas) {
  const std::size_t errors_before = context.diagnostics.error_count();
  std::vector<double> q = context.start();
  for (Closure& closure : context.tree.closures)
    if (context.diagnostics.error_count() == errors_before) assemble_by_formula(context, closure, q);
  for (const std::vector<int>& loops : without_formulas)
    if (std::optional<Closure> together = iterative_closure(context, loops, q))
      context.tree.closures.push_back(std::move(*together));
  return q;
}

// The coordinates, or dependent joints of other closures, that the dependent joints of this closure follow.
std::set<int> leaders_of(const KinematicTree& tree, const Closure& closure) {
  std::set<int> leaders;
  for (const int loop : closure.loops)
    for (const int joint : joints_of(tree.loops[at(loop)])) {
      if (std::find(closure.dependents.begin(), closure.dependents.end(), joint) != closure.dependents.end()) continue;
      if (const Coupling* coupling = tree.coupling_of(joint))
        for (const Coupling::Term& term : coupling->terms) leaders.insert(term.joint);
      else
        leaders.insert(joint);
    }
  return leaders;
}

// Adds a coupling for each dependent joint.
void add_couplings(KinematicTree& tree, const std::vector<double>& q) {
  for (std::size_t k = 0; k < tree.closures.size(); ++k) {
    const std::set<int> leaders = leaders_of(tree, tree.closures[k]);
    for (const int joint : tree.closures[k].dependents) {
      Coupling coupling;
      coupling.joint = joint;
      for (const int leader : leaders) coupling.terms.push_back({leader, Quantity()});
      coupling.closure = static_cast<int>(k);
      coupling.offset = Quantity(q[at(joint)]);
      const auto place = std::lower_bound(
          tree.couplings.begin(), tree.couplings.end(), joint, [](const Coupling& c, int j) { return c.joint < j; });
      tree.couplings.insert(place, std::move(coupling));
    }
  }
}

}  // namespace

void resolve_loops(const Description& description, KinematicTree& tree, Diagnostics& diagnostics) {
  const auto says_assembled = [](const DescribedJoint& joint) { return joint.assembled.has_value(); };
  if (description.loops.empty() && description.independents.empty() &&
      std::none_of(description.joints.begin(), description.joints.end(), says_assembled))
    return;
  const std::size_t errors_before = diagnostics.error_count();
  LoopContext context = context_of(description, tree, diagnostics);
  declare_loops(description, context);
  if (diagnostics.error_count() == errors_before) report_spherical_joints(context);
  if (diagnostics.error_count() > errors_before) return;
  const std::vector<std::vector<int>> without_formulas = add_formula_closures(context);
  if (diagnostics.error_count() > errors_before) return;
  couple_parallelograms(tree);
  const std::vector<double> q = assemble(context, without_formulas);
  if (diagnostics.error_count() == errors_before) add_couplings(tree, q);
}

KinematicTree with_free_joints(const KinematicTree& tree) {
  KinematicTree free = tree;
  free.couplings.clear();
  free.closures.clear();
  free.parallelograms.clear();
  free.inertia_defects = inertia_defects(free);
  return free;
}

}  // namespace robcogen::model
