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

constexpr double kOneRule = 1e-8;  // rad, m: closer values are of one rule, before and after other frames change

bool are_near(const Quantity& a, const Quantity& b) {
  if (!a.is_constant() || !b.is_constant()) return a == b;
  return std::abs(a.number().value() - b.number().value()) < kOneRule;
}

// The value that the same rule gives for the follower; if it gives none because candidates coincide, one of the same
// size.
std::optional<Quantity> counterpart(
    const Quantity& value,
    const std::vector<Candidate>& of_leader,
    const std::vector<Candidate>& of_follower) {
  const auto chosen =
      std::find_if(of_leader.begin(), of_leader.end(), [&](const Candidate& c) { return are_near(c.value, value); });
  if (chosen == of_leader.end()) return std::nullopt;
  if (const Candidate* same_rule = find_rule(of_follower, chosen->rule)) return same_rule->value;
  const auto same_size = std::find_if(of_follower.begin(), of_follower.end(), [&](const Candidate& c) {
    return are_near(c.value, value) || are_near(c.value, -value);
  });
  return same_size == of_follower.end() ? std::nullopt : std::optional(same_size->value);
}

// The frame that the follower takes from the leader. In `frames`, those of their parents are final.
std::optional<LinkFrame> following(const FrameCandidates& candidates, LinkFrames frames, int leader, int follower) {
  const LinkFrame frame = frames[at(leader)];
  frames[at(leader)] = frames[at(follower)] = LinkFrame();
  const std::optional<Quantity> turn =
      counterpart(frame.turn, candidates.turns(leader, frames), candidates.turns(follower, frames));
  if (!turn) return std::nullopt;
  const std::optional<Quantity> slide = counterpart(
      frame.slide, candidates.slides(leader, frame.turn, frames), candidates.slides(follower, *turn, frames));
  if (!slide) return std::nullopt;
  return LinkFrame{*turn, *slide, frame.turns_with_joint};
}

// Gives all limbs the frames of the first one. `frames` stay unchanged if a follower has no such frame.
void follow(const FrameCandidates& candidates, const LimbsInLanes& limbs, LinkFrames& frames) {
  LinkFrames result = frames;
  for (const std::vector<int>& joints : limbs.joints) {
    for (std::size_t lane = 1; lane < joints.size(); ++lane) {
      const std::optional<LinkFrame> frame = following(candidates, result, joints.front(), joints[lane]);
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
  for (const LimbsInLanes& limbs : limbs_in_lanes(tree)) follow(candidates, limbs, frames);
  return frames;
}

}  // namespace robcogen::algorithm
