#include "algorithm/search/limb_trials.h"

#include <algorithm>
#include <utility>

#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;

// The numbers of the view's joints and links.
std::shared_ptr<const LinkNumbers> numbers_of(
    const KinematicTree& tree,
    const LimbView& view,
    const std::shared_ptr<const LinkNumbers>& all) {
  if (!all) return nullptr;
  LinkNumbers result;
  result.masses.push_back(all->masses[0]);
  for (const int j : view.joints) {
    result.placements.push_back(all->placements[at(j)]);
    result.masses.push_back(all->masses[at(tree.joints[at(j)].child)]);
  }
  return std::make_shared<const LinkNumbers>(std::move(result));
}

LinkFrames frames_of_view(const LimbView& view, const LinkFrames& frames) {
  LinkFrames result;
  result.reserve(view.joints.size());
  for (const int j : view.joints) result.push_back(frames[at(j)]);
  return result;
}

}  // namespace

Trial& Trials::in_frames(const LinkFrames& frames, const std::function<symbolic::TracedCost()>& trace) {
  known_.resize(frames.size());
  std::vector<int> key;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto found = std::find(known_[i].begin(), known_[i].end(), frames[i]);
    key.push_back(static_cast<int>(found - known_[i].begin()));
    if (found == known_[i].end()) known_[i].push_back(frames[i]);
  }
  const auto done = done_.find(key);
  return done != done_.end() ? done->second : done_.emplace(std::move(key), Trial{trace()}).first->second;
}

LimbTrials::LimbTrials(
    const KinematicTree& tree,
    const Formulation& formulation,
    const TraceOf& trace,
    const std::shared_ptr<const LinkNumbers>& numbers,
    const std::vector<bool>& left_out)
    : formulation_(formulation), trace_(trace), limbs_(tree.joints.size()) {
  for (int j = 0; j < static_cast<int>(tree.joints.size()); ++j) {
    if (!left_out.empty() && left_out[at(j)]) continue;
    LimbView view = limb_view(tree, j, left_out);
    std::shared_ptr<const LinkNumbers> own = numbers_of(tree, view, numbers);
    limbs_[at(j)] = {std::move(view), std::move(own), nullptr, {}};
  }
}

Trial& LimbTrials::of(int joint, const LinkFrames& frames) {
  Limb& limb = limbs_[at(joint)];
  const LinkFrames own = frames_of_view(limb.view, frames);
  return limb.trials.in_frames(own, [&] {
    Trace trace(limb.view.tree);
    trace.graph.reserve(limb.nodes);
    trace_(trace, draft(limb, own));
    limb.nodes = std::max(limb.nodes, trace.graph.nodes().size());
    return trace.cost();
  });
}

bool LimbTrials::keeps_digits(int joint, const LinkFrames& frames, Trial& trial) {
  Limb& limb = limbs_[at(joint)];
  const KinematicTree& tree = limb.view.tree;
  if (!limb.results) limb.results = results_of(tree, trace_, draft(limb, LinkFrames(limb.view.joints.size())));
  if (!trial.keeps_digits) {
    const Formulation choice = draft(limb, frames_of_view(limb.view, frames));
    trial.keeps_digits = limb.results->are_kept_by(program_of(tree, trace_, choice));
  }
  return *trial.keeps_digits;
}

Formulation LimbTrials::draft(const Limb& limb, LinkFrames frames) const {
  Formulation choice = formulation_;
  choice.is_draft = true;
  choice.numbers = limb.numbers;
  choice.frames = std::move(frames);
  return choice;
}

symbolic::Program program_of(const KinematicTree& tree, const TraceOf& trace_of, const Formulation& formulation) {
  Trace trace(tree);
  trace_of(trace, formulation);
  return trace.program("");
}

std::shared_ptr<const symbolic::AccurateResults> results_of(
    const KinematicTree& tree,
    const TraceOf& trace,
    const Formulation& formulation) {
  return std::make_shared<const symbolic::AccurateResults>(
      program_of(tree, trace, formulation), parameter_values(tree));
}

}  // namespace robcogen::algorithm
