#include "export/urdf_loops.h"

#include <algorithm>
#include <array>
#include <map>

#include "model/loop_ends.h"
#include "support/index.h"

namespace robcogen::exporting {
namespace {

using model::Coupling;
using model::KinematicTree;

constexpr std::array kEnds = {"predecessor", "successor"};

// How the joint follows the others, given that this sum of positions is zero; nullopt if the joint is not part of it.
std::optional<std::map<int, double>> solved_for(int joint, const std::map<int, double>& sum) {
  const auto own = sum.find(joint);
  if (own == sum.end() || own->second == 0.0) return std::nullopt;
  std::map<int, double> terms;
  for (const auto& [other, factor] : sum)
    if (other != joint && factor != 0.0) terms[other] = -factor / own->second;
  return terms;
}

bool is_same(const std::map<int, double>& terms, const Coupling& coupling) {
  return terms.size() == coupling.terms.size() &&
         std::all_of(coupling.terms.begin(), coupling.terms.end(), [&](const Coupling::Term& term) {
           const auto found = terms.find(term.joint);
           return found != terms.end() && found->second == model::evaluate(term.factor);
         });
}

}  // namespace

std::optional<LinkCoupling> link_coupling(const KinematicTree& tree, const Coupling& coupling) {
  if (!coupling.is_linear() || coupling.terms.empty() || !coupling.offset.is_zero()) return std::nullopt;
  std::vector<std::vector<int>> paths;
  for (std::size_t link = 0; link < tree.links.size(); ++link)
    paths.push_back(model::joints_from_base(tree, static_cast<int>(link)));
  std::vector<double> ratios;
  for (const Coupling::Term& term : coupling.terms) {
    const double factor = model::evaluate(term.factor);
    ratios.insert(ratios.end(), {factor, 1.0 / factor});
  }
  for (std::size_t predecessor = 0; predecessor < paths.size(); ++predecessor)
    for (std::size_t successor = 0; successor < paths.size(); ++successor) {
      const std::vector<int>&first = paths[predecessor], &second = paths[successor];
      const auto [a, b] = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
      for (const double ratio : ratios) {
        std::map<int, double> sum;
        for (auto joint = b; joint != second.end(); ++joint) sum[*joint] = 1.0;
        for (auto joint = a; joint != first.end(); ++joint) sum[*joint] = -ratio;
        if (const auto terms = solved_for(coupling.joint, sum); terms && is_same(*terms, coupling))
          return LinkCoupling{static_cast<int>(predecessor), static_cast<int>(successor), ratio};
      }
    }
  return std::nullopt;
}

bool may_be_urdf_loop(const model::LoopJoint& loop) {
  return loop.type == model::LoopType::hinge && !loop.takes_other_branch;
}

bool follows_through_loop(const KinematicTree& tree, int joint) {
  const Coupling* coupling = tree.coupling_of(joint);
  return coupling != nullptr && (!coupling->is_linear() || coupling->loop >= 0);
}

bool is_made_by_loop(const KinematicTree& tree, const std::string& frame) {
  return std::any_of(tree.loops.begin(), tree.loops.end(), [&](const model::LoopJoint& loop) {
    for (std::size_t e = 0; e < kEnds.size(); ++e)
      if (loop.ends[e].frame == frame && frame == loop.name + "_" + kEnds[e]) return true;
    return false;
  });
}

}  // namespace robcogen::exporting
