#include "algorithm/search/frame_search.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "algorithm/search/frame_candidates.h"
#include "model/limbs.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;

// Statements that may be traced at effort 1.
constexpr long kStatements = 2'000'000;
constexpr int kRounds = 3;
// The constants of a choice may be larger than those before it by this factor.
constexpr double kLarger = 16.0;

// An accepted change, recorded by its rules so that limbs of the same shape can take it too.
struct Step {
  int joint = 0;
  int turn_rule = 0, slide_rule = 0;
  bool turns = true;
  std::optional<bool> parent_turns = {};
};
using Steps = std::vector<Step>;

// The frames with this one for the joint, and with the frame of its parent as the step says.
LinkFrames changed(const KinematicTree& tree, LinkFrames frames, int joint, const LinkFrame& frame, const Step& step) {
  frames[at(joint)] = frame;
  if (step.parent_turns) frames[at(tree.parent_joint_of(joint))].turns_with_joint = *step.parent_turns;
  return frames;
}

// By joint: the corresponding joints of congruent limbs, for the joints of the limb of each class that costs most:
// numbers that vanish in other limbs only are no gain in lanes.
std::vector<std::vector<int>> counterparts(
    const KinematicTree& tree,
    const Formulation& formulation,
    const TraceOf& trace,
    const std::shared_ptr<const LinkNumbers>& numbers,
    const LinkFrames& frames) {
  std::vector<std::vector<int>> result(tree.joints.size());
  const std::vector<model::LimbClass> classes = model::limb_classes(tree);
  if (classes.empty()) return result;
  LimbTrials trials(tree, formulation, trace, numbers);
  for (const model::LimbClass& limbs : classes) {
    const auto work = [&](const std::vector<int>& limb) { return trials.of(limb.front(), frames).cost.work; };
    const auto first = std::max_element(
        limbs.limbs.begin(), limbs.limbs.end(),
        [&](const std::vector<int>& a, const std::vector<int>& b) { return work(a) < work(b); });
    const std::ptrdiff_t place = first - limbs.limbs.begin();
    for (std::size_t k = 0; k < limbs.length(); ++k) {
      std::vector<int> joints = limbs.corresponding(k);
      const int joint = joints[static_cast<std::size_t>(place)];
      joints.erase(joints.begin() + place);
      result[at(joint)] = std::move(joints);
    }
  }
  return result;
}

std::vector<bool> are_among(const std::vector<std::vector<int>>& counterparts) {
  std::vector<bool> result(counterparts.size(), false);
  for (const std::vector<int>& joints : counterparts)
    for (const int joint : joints) result[at(joint)] = true;
  return result;
}

LinkFrames start_of(const KinematicTree& tree, const Formulation& formulation) {
  return formulation.frames.empty() ? LinkFrames(tree.joints.size()) : formulation.frames;
}

// Coordinate descent: each limb that is visited replaces the frames so far by cheaper ones. Of congruent limbs that can
// share lanes only the first is visited; the others take each of its steps by the same rules.
class Descent {
 public:
  Descent(const KinematicTree& tree, const Formulation& formulation, const TraceOf& trace)
      : tree_(tree),
        formulation_(formulation),
        candidates_(tree, formulation),
        shapes_(model::limb_shapes(tree)),
        counterparts_(counterparts(tree, formulation, trace, candidates_.numbers(), start_of(tree, formulation))),
        is_counterpart_(are_among(counterparts_)),
        trials_(tree, formulation, trace, candidates_.numbers(), is_counterpart_),
        constant_bounds_(tree.joints.size(), 0.0),
        left_(kStatements * formulation.effort),
        frames_(start_of(tree, formulation)) {}

  // Returns the initial frames and those after each change.
  std::vector<LinkFrames> run() {
    history_.push_back(frames_);
    for (int round = 0; round < kRounds; ++round)
      if (visit(0).empty()) break;
    return std::move(history_);
  }

 private:
  const KinematicTree& tree_;
  const Formulation& formulation_;
  const FrameCandidates candidates_;
  const std::vector<int> shapes_;                     // of limbs, by joint
  const std::vector<std::vector<int>> counterparts_;  // by joint
  const std::vector<bool> is_counterpart_;            // by joint
  LimbTrials trials_;
  std::vector<double> constant_bounds_;  // by joint: the largest constant allowed; zero before its first visit
  long left_;                            // statements that may still be traced
  LinkFrames frames_;
  std::vector<LinkFrames> history_;

  // The trial of the joint's limb in these frames. A repeated trial is not traced again, so it does not count.
  Trial& tried(int joint, const LinkFrames& frames) {
    Trial& trial = trials_.of(joint, frames);
    if (!trial.is_counted) left_ -= trial.cost.statements;
    trial.is_counted = true;
    return trial;
  }

  void take(LinkFrames frames) {
    frames_ = std::move(frames);
    history_.push_back(frames_);
  }

  // The frames after a joint takes a step; nullopt if it has no such candidates.
  std::optional<LinkFrames> stepped(LinkFrames frames, int joint, const Step& step) const {
    const std::vector<Candidate> turns = candidates_.turns(joint, frames);
    const Candidate* turn = find_rule(turns, step.turn_rule);
    if (!turn) return std::nullopt;
    const std::vector<Candidate> slides = candidates_.slides(joint, turn->value, frames);
    const Candidate* slide = find_rule(slides, step.slide_rule);
    if (!slide) return std::nullopt;
    return changed(tree_, std::move(frames), joint, {turn->value, slide->value, step.turns}, step);
  }

  // The frames after the counterparts of a joint take its step, too.
  std::optional<LinkFrames> followed_by_counterparts(LinkFrames frames, int joint, const Step& step) const {
    std::optional<LinkFrames> result = std::move(frames);
    for (const int other : counterparts_[at(joint)])
      if (result) result = stepped(std::move(*result), other, step);
    return result;
  }

  // Visits all limbs that are attached to a link and returns their steps. A limb of the same shape as an earlier one
  // tries to follow that one.
  Steps visit(int link) {
    struct Done {
      int joint;
      Steps steps;
      int cost;
    };
    std::vector<Done> done;
    Steps all;
    for (const int joint : tree_.links[at(link)].child_joints) {
      if (is_counterpart_[at(joint)]) continue;
      const auto twin = std::find_if(
          done.begin(), done.end(), [&](const Done& other) { return shapes_[at(other.joint)] == shapes_[at(joint)]; });
      Steps steps;
      if (twin == done.end() || !follow(joint, twin->joint, twin->steps, twin->cost)) {
        steps = improve(joint);
        const Steps beyond = visit(tree_.joints[at(joint)].child);
        steps.insert(steps.end(), beyond.begin(), beyond.end());
      }
      all.insert(all.end(), steps.begin(), steps.end());
      done.push_back({joint, std::move(steps), tried(joint, frames_).cost.work});
    }
    return all;
  }

  // Takes the steps of a limb of the same shape and returns whether they cost the same here. Otherwise nothing changes.
  bool follow(int joint, int leader, const Steps& steps, int expected) {
    const std::vector<int> from = model::limb_joints(tree_, shapes_, leader);
    const std::vector<int> to = model::limb_joints(tree_, shapes_, joint);
    std::map<int, int> counterpart;
    for (std::size_t i = 0; i < from.size(); ++i) counterpart[from[i]] = to[i];
    std::optional<LinkFrames> frames = frames_;
    for (const Step& step : steps) {
      const int own = counterpart.at(step.joint);
      frames = stepped(std::move(*frames), own, step);
      if (frames) frames = followed_by_counterparts(std::move(*frames), own, step);
      if (!frames) return false;
    }
    Trial& trial = tried(joint, *frames);
    if (trial.cost.work != expected) return false;
    if (steps.empty()) return true;
    if (!trials_.keeps_digits(joint, *frames, trial)) return false;
    take(std::move(*frames));
    return true;
  }

  // The cost that a joint's candidates are compared with, and the changes that lowered it.
  struct Improvement {
    int joint;
    int best;
    double largest_constant;
    Steps steps = {};
  };

  void attempt(Improvement& so_far, const LinkFrame& frame, Step step) {
    if (left_ <= 0) return;
    const int joint = so_far.joint;
    LinkFrames frames = changed(tree_, frames_, joint, frame, step);
    Trial& trial = tried(joint, frames);
    const symbolic::TracedCost& cost = trial.cost;
    if (cost.work >= so_far.best || cost.largest_constant > so_far.largest_constant) return;
    step.joint = joint;
    step.turns = frame.turns_with_joint;
    std::optional<LinkFrames> all = followed_by_counterparts(frames, joint, step);
    if (!all || !trials_.keeps_digits(joint, frames, trial)) return;
    so_far.best = cost.work;
    take(std::move(*all));
    so_far.steps.push_back(step);
  }

  // Tries frames that turn with the joint and frames that do not. Arguments are passed by value, because an accepted
  // frame replaces frames_.
  void attempt_both(Improvement& so_far, model::Quantity turn, model::Quantity slide, const Step& step) {
    for (const bool turns : {true, false})
      if (turns || formulation_.turn_inertia) attempt(so_far, {turn, slide, turns}, step);
  }

  // Tries turns, then slides at the best turn.
  Steps improve(int joint) {
    if (tree_.joints[at(joint)].type == model::JointType::spherical)
      return {};  // it has no axis to turn about or slide along
    const symbolic::TracedCost start = tried(joint, frames_).cost;
    double& bound = constant_bounds_[at(joint)];
    if (bound == 0.0) bound = kLarger * start.largest_constant;
    Improvement result{joint, start.work, bound};
    if (formulation_.choose_frames) {
      for (const Candidate& turn : candidates_.turns(joint, frames_))
        attempt_both(result, turn.value, frames_[at(joint)].slide, {.turn_rule = turn.rule});
      const model::Quantity turn = frames_[at(joint)].turn;
      for (const Candidate& slide : candidates_.slides(joint, turn, frames_))
        attempt_both(result, turn, slide.value, {.slide_rule = slide.rule});
    }
    if (formulation_.turn_inertia) attempt_turning(result);
    return std::move(result.steps);
  }

  // Tries frames that turn with the joint and frames that do not, then both with either choice for the parent.
  void attempt_turning(Improvement& result) {
    const int joint = result.joint;
    attempt_both(result, frames_[at(joint)].turn, frames_[at(joint)].slide, {});
    if (tree_.parent_joint_of(joint) < 0) return;
    for (const bool parent_turns : {true, false})
      attempt_both(result, frames_[at(joint)].turn, frames_[at(joint)].slide, {.parent_turns = parent_turns});
  }
};

// Late frames with which the whole robot keeps the digits that the plain formulation keeps, found by going back in
// doubling steps; if there are none, those of `formulation`. During the search limbs are judged one by one.
LinkFrames accurate_frames(
    const KinematicTree& tree,
    const Formulation& formulation,
    const TraceOf& trace,
    const std::vector<LinkFrames>& history) {
  Formulation plain = plain_formulation();
  plain.is_draft = true;
  const std::shared_ptr<const symbolic::AccurateResults> results = results_of(tree, trace, plain);
  Formulation choice = formulation;
  choice.is_draft = true;
  for (std::size_t back = 1; back <= history.size(); back *= 2) {
    choice.frames = history[history.size() - back];
    if (results->are_kept_by(program_of(tree, trace, choice))) return choice.frames;
  }
  return formulation.frames;
}

}  // namespace

LinkFrames cheap_frames(const KinematicTree& tree, const Formulation& formulation, const TraceOf& trace) {
  if (formulation.effort <= 0 || (!formulation.choose_frames && !formulation.turn_inertia)) return formulation.frames;
  return accurate_frames(tree, formulation, trace, Descent(tree, formulation, trace).run());
}

}  // namespace robcogen::algorithm
