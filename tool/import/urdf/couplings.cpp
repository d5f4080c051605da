// Couplings of URDF+. Each states that a sum over joints is zero; these sums are solved for the joints that follow.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "import/linear_relations.h"
#include "import/urdf/link_pair.h"
#include "import/urdf/loops.h"
#include "support/index.h"

namespace robcogen::import::from_urdf {
namespace {

// Returns nullopt after reporting an error.
std::optional<LinearRelation> relation(
    const Coupling& coupling,
    const Document& document,
    const Topology& topology,
    const std::vector<Carried>& carried,
    Diagnostics& diagnostics) {
  const std::string owner = fmt::format("coupling '{}'", coupling.name.text);
  const auto pair = find_link_pair(coupling.links, owner, document, topology, carried, diagnostics);
  if (!pair) return std::nullopt;
  LinearRelation factors;
  for (std::size_t e = 0; e < 2; ++e)
    for (const int j : pair->paths[e]) {
      const Joint& joint = document.joints[at(j)];
      if (!is_movable(joint)) {
        diagnostics.error(
            "coupling-without-joint", coupling.links[e].place,
            fmt::format("{}: {} joint '{}' is between its links", owner, name_of(joint.type), joint.name.text));
        return std::nullopt;
      }
      const Number factor = e == 0 ? -coupling.ratio : Number::rational(1);
      if (!factor.is_zero()) factors[j] = factor;
    }
  return factors;
}

void report(const SolvedRelations::Unsolved& unsolved, const Name& coupling, Diagnostics& diagnostics) {
  if (unsolved.is_redundant) {
    diagnostics.error(
        "coupling-redundant", coupling.place,
        fmt::format("coupling '{}' is redundant with other couplings, or has no joint", coupling.text));
    return;
  }
  diagnostics
      .error(
          "coupling-without-follower", coupling.place,
          fmt::format("none of the joints of coupling '{}' can follow the others", coupling.text))
      .hint = "give one of them independent=\"false\"";
}

}  // namespace

void add_couplings(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const std::vector<bool>& may_follow,
    model::Description& description,
    Diagnostics& diagnostics) {
  const std::vector<Carried> carried = carry(document, topology);
  std::vector<const Name*> names;
  std::vector<LinearRelation> relations;
  for (const Coupling& coupling : document.couplings) {
    auto factors = relation(coupling, document, topology, carried, diagnostics);
    if (!factors) continue;
    names.push_back(&coupling.name);
    relations.push_back(std::move(*factors));
  }
  const SolvedRelations solved = solve(relations, [&](int joint) { return may_follow[at(joint)]; });
  for (const auto& unsolved : solved.unsolved) report(unsolved, *names[unsolved.relation], diagnostics);
  for (const auto& [joint, follower] : solved.followers) {
    const Place& place = names[follower.relation]->place;
    model::DescribedCoupling coupling = {identifiers.joints[at(joint)], place, {}, {}};
    for (const auto& [followed, factor] : follower.sum)
      if (followed != joint)
        coupling.terms.push_back({identifiers.joints[at(followed)], model::Quantity(-factor), place});
    description.couplings.push_back(std::move(coupling));
  }
}

}  // namespace robcogen::import::from_urdf
