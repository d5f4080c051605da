#include "algorithm/search/corresponding_frames.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithm/formulation/congruent_limbs.h"
#include "algorithm/search/frame_candidates.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::Quantity;

// rad, m. Values of one rule change by less than this when other frames change.
constexpr double kOneRule = 1e-8;

bool are_near(const Quantity& a, const Quantity& b) {
  if (!a.is_constant() || !b.is_constant()) return a == b;
  return std::abs(a.number().value() - b.number().value()) < kOneRule;
}

// The candidate of another limb that corresponds to a value of the first limb: the candidate of the same rule. If the
// rule has none, because two candidates of that limb coincide, a candidate of the same magnitude.
std::optional<Quantity> corresponding(
    const Quantity& value,
    const std::vector<Candidate>& of_first,
    const std::vector<Candidate>& of_other) {
  const auto chosen =
      std::find_if(of_first.begin(), of_first.end(), [&](const Candidate& c) { return are_near(c.value, value); });
  if (chosen == of_first.end()) return std::nullopt;
  if (const Candidate* same_rule = find_rule(of_other, chosen->rule)) return same_rule->value;
  const auto same_magnitude = std::find_if(of_other.begin(), of_other.end(), [&](const Candidate& c) {
    return are_near(c.value, value) || are_near(c.value, -value);
  });
  return same_magnitude == of_other.end() ? std::nullopt : std::optional(same_magnitude->value);
}

// The frame behind joint `other` that corresponds to the frame behind joint `first` of the first limb. The frames of
// their parent links are final in `frames`.
std::optional<LinkFrame> corresponding_frame(
    const FrameCandidates& candidates,
    LinkFrames frames,
    int first,
    int other) {
  const LinkFrame frame = frames[at(first)];
  frames[at(first)] = frames[at(other)] = LinkFrame();
  const std::optional<Quantity> turn =
      corresponding(frame.turn, candidates.turns(first, frames), candidates.turns(other, frames));
  if (!turn) return std::nullopt;
  const std::optional<Quantity> slide =
      corresponding(frame.slide, candidates.slides(first, frame.turn, frames), candidates.slides(other, *turn, frames));
  if (!slide) return std::nullopt;
  return LinkFrame{*turn, *slide, frame.turns_with_joint};
}

// Gives all limbs of a class the frames of the first limb. `frames` stay unchanged if one limb has no such frame.
void make_correspond(const FrameCandidates& candidates, const LimbsInLanes& limbs, LinkFrames& frames) {
  LinkFrames result = frames;
  for (const std::vector<int>& joints : limbs.joints) {
    for (std::size_t lane = 1; lane < joints.size(); ++lane) {
      const std::optional<LinkFrame> frame = corresponding_frame(candidates, result, joints.front(), joints[lane]);
      if (!frame) return;
      result[at(joints[lane])] = *frame;
    }
  }
  frames = std::move(result);
}

}  // namespace

LinkFrames corresponding_frames(const model::KinematicTree& tree, const Formulation& formulation) {
  LinkFrames frames = formulation.frames;
  if (frames.empty()) return frames;
  const FrameCandidates candidates(tree, formulation);
  for (const LimbsInLanes& limbs : limbs_in_lanes(tree)) make_correspond(candidates, limbs, frames);
  return frames;
}

}  // namespace robcogen::algorithm
