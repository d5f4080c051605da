#include "algorithm/search/frame_search.h"

#include <algorithm>
#include <map>
#include <optional>

#include "algorithm/search/frame_candidates.h"
#include "algorithm/search/limb_view.h"
#include "algorithm/search/trials.h"
#include "algorithm/spatial/trace.h"
#include "model/limbs.h"
#include "support/index.h"
#include "symbolic/accuracy.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;

// Statements that may be traced at effort 1.
constexpr long kStatements = 2'000'000;
constexpr int kRounds = 3;
// Constants of a choice may be larger than those before it by this factor.
constexpr double kLarger = 16.0;

// An accepted change.
struct Step {
  int joint = 0;
  int turn_rule = 0, slide_rule = 0;
  bool turns = true;
  std::optional<bool> parent_turns = {};
};

class Search {
 public:
  Search(const KinematicTree& tree, const Formulation& formulation, const TraceOf& trace)
      : tree_(tree),
        formulation_(formulation),
        trace_(trace),
        candidates_(tree, formulation),
        shapes_(model::limb_shapes(tree)),
        frames_(formulation.frames),
        left_(kStatements * formulation.effort) {
    if (frames_.empty()) frames_.resize(tree.joints.size());
    const std::shared_ptr<const LinkNumbers> numbers = candidates_.numbers();
    for (int j = 0; j < static_cast<int>(tree.joints.size()); ++j) {
      LimbView view = limb_view(tree, j);
      std::shared_ptr<const LinkNumbers> of_view = numbers ? numbers_of(view, *numbers) : nullptr;
      views_.push_back({std::move(view), std::move(of_view), nullptr, {}, 0.0});
    }
  }

  LinkFrames run() {
    history_.push_back(frames_);
    for (int round = 0; round < kRounds; ++round) {
      taken_.clear();
      visit(0);
      if (taken_.empty()) break;
    }
    return accurate_frames();
  }

 private:
  // What a joint has to do with, and what its traces take from the model of a robot without parameters.
  struct View {
    LimbView limb;
    std::shared_ptr<const LinkNumbers> numbers;
    std::shared_ptr<const symbolic::AccurateResults> results;  // once they were asked for
    Trials trials;
    double largest_constant = 0.0;  // that a choice may have
  };

  const KinematicTree& tree_;
  const Formulation& formulation_;
  const TraceOf& trace_;
  FrameCandidates candidates_;
  std::vector<int> shapes_;  // of limbs, by joint
  std::vector<View> views_;  // by joint
  LinkFrames frames_;
  long left_;
  std::vector<Step> taken_;          // in this round
  std::vector<LinkFrames> history_;  // after each change

  // All limbs that hang on a link; one that is like an earlier one follows it.
  void visit(int link) {
    struct Done {
      int joint;
      std::size_t first, last;  // of taken_
      int cost;
    };
    std::vector<Done> done;
    for (const int joint : tree_.links[at(link)].child_joints) {
      const auto twin = std::find_if(
          done.begin(), done.end(), [&](const Done& other) { return shapes_[at(other.joint)] == shapes_[at(joint)]; });
      const std::size_t first = taken_.size();
      if (twin == done.end() || !follow(joint, twin->joint, twin->first, twin->last, twin->cost)) {
        improve(joint);
        visit(tree_.joints[at(joint)].child);
      }
      done.push_back({joint, first, taken_.size(), tried(joint, frames_).work});
    }
  }

  // Takes the steps of a limb of the same shape; whether that costs the same there. Otherwise nothing changes.
  bool follow(int joint, int leader, std::size_t first, std::size_t last, int expected) {
    const LinkFrames before = frames_;
    const std::vector<int> from = model::limb_joints(tree_, shapes_, leader);
    const std::vector<int> to = model::limb_joints(tree_, shapes_, joint);
    std::map<int, int> counterpart;
    for (std::size_t i = 0; i < from.size(); ++i) counterpart[from[i]] = to[i];
    for (std::size_t i = first; i < last; ++i) {
      const Step& step = taken_[i];
      const auto own = counterpart.find(step.joint);
      if (own == counterpart.end() || !take(own->second, step)) {
        frames_ = before;
        return false;
      }
    }
    Trial& trial = tried(joint, frames_);
    if (trial.work == expected && (first == last || keeps_digits(joint, frames_, trial))) {
      if (first != last) history_.push_back(frames_);
      return true;
    }
    frames_ = before;
    return false;
  }

  bool take(int joint, const Step& step) {
    const auto find = [](const std::vector<Candidate>& list, int rule) {
      return std::find_if(list.begin(), list.end(), [&](const Candidate& c) { return c.rule == rule; });
    };
    const std::vector<Candidate> turns = candidates_.turns(joint, frames_);
    const auto turn = find(turns, step.turn_rule);
    if (turn == turns.end()) return false;
    const std::vector<Candidate> slides = candidates_.slides(joint, turn->value, frames_);
    const auto slide = find(slides, step.slide_rule);
    if (slide == slides.end()) return false;
    frames_[at(joint)] = {turn->value, slide->value, step.turns};
    if (step.parent_turns) frames_[at(tree_.parent_joint_of(joint))].turns_with_joint = *step.parent_turns;
    return true;
  }

  // What the joint has to do with, in these frames. The bound counts what is asked for again, too: it is one on what is
  // tried.
  Trial& tried(int joint, const LinkFrames& frames) {
    Trial& trial =
        views_[at(joint)].trials.in_frames(frames_of_view(joint, frames), [&] { return traced(joint, frames); });
    left_ -= trial.statements;
    return trial;
  }

  LinkFrames frames_of_view(int joint, const LinkFrames& frames) const {
    LinkFrames result;
    for (const int j : views_[at(joint)].limb.joints) result.push_back(frames[at(j)]);
    return result;
  }

  symbolic::Program traced(int joint, const LinkFrames& frames) const {
    const View& view = views_[at(joint)];
    return trace_(view.limb.tree, draft(view, frames_of_view(joint, frames)));
  }

  Formulation draft(const View& view, LinkFrames frames) const {
    Formulation choice = formulation_;
    choice.is_draft = true;
    choice.numbers = view.numbers;
    choice.frames = std::move(frames);
    return choice;
  }

  // Whether a trace of what the joint has to do with keeps the digits that it keeps in the frames of the model: with
  // the same mass properties, which other limbs may have a share in.
  bool keeps_digits(int joint, const LinkFrames& frames, Trial& trial) {
    View& view = views_[at(joint)];
    if (!view.results) view.results = results_of(view.limb.tree, draft(view, LinkFrames(view.limb.joints.size())));
    if (!trial.keeps_digits) trial.keeps_digits = view.results->are_kept_by(traced(joint, frames));
    return *trial.keeps_digits;
  }

  std::shared_ptr<const symbolic::AccurateResults> results_of(const KinematicTree& part, const Formulation& choice)
      const {
    return std::make_shared<const symbolic::AccurateResults>(trace_(part, choice), parameter_values(part));
  }

  // The last frames with which the whole robot keeps the digits that the plain formulation keeps: limbs are judged one
  // by one while they change.
  LinkFrames accurate_frames() const {
    Formulation plain = plain_formulation();
    plain.is_draft = true;
    const std::shared_ptr<const symbolic::AccurateResults> results = results_of(tree_, plain);
    Formulation choice = formulation_;
    choice.is_draft = true;
    for (std::size_t back = 1; back <= history_.size(); back *= 2) {
      choice.frames = history_[history_.size() - back];
      if (results->are_kept_by(trace_(tree_, choice))) return choice.frames;
    }
    return formulation_.frames;
  }

  // Of the view's joints and links.
  std::shared_ptr<const LinkNumbers> numbers_of(const LimbView& view, const LinkNumbers& all) const {
    LinkNumbers result;
    result.masses.push_back(all.masses[0]);
    for (const int j : view.joints) {
      result.placements.push_back(all.placements[at(j)]);
      result.masses.push_back(all.masses[at(tree_.joints[at(j)].child)]);
    }
    return std::make_shared<const LinkNumbers>(std::move(result));
  }

  // Turns, then slides at the best turn; each with and without the joint's turning.
  void improve(int joint) {
    if (tree_.joints[at(joint)].type == model::JointType::spherical) return;  // it has no axis to turn or slide about
    const Trial& start = tried(joint, frames_);
    int best = start.work;
    double& most = views_[at(joint)].largest_constant;
    if (most == 0.0) most = kLarger * start.largest_constant;
    const auto attempt = [&](const LinkFrame& frame, Step step) {
      if (left_ <= 0) return;
      LinkFrames frames = frames_;
      frames[at(joint)] = frame;
      if (step.parent_turns) frames[at(tree_.parent_joint_of(joint))].turns_with_joint = *step.parent_turns;
      Trial& trial = tried(joint, frames);
      if (trial.work >= best || trial.largest_constant > most || !keeps_digits(joint, frames, trial)) return;
      best = trial.work;
      frames_ = std::move(frames);
      history_.push_back(frames_);
      step.joint = joint;
      step.turns = frame.turns_with_joint;
      taken_.push_back(step);
    };
    // By value: what is accepted replaces frames_.
    const auto attempt_both = [&](model::Quantity turn, model::Quantity slide, const Step& step) {
      for (const bool turns : {true, false})
        if (turns || formulation_.turn_inertia) attempt({turn, slide, turns}, step);
    };
    if (formulation_.choose_frames) {
      for (const Candidate& turn : candidates_.turns(joint, frames_))
        attempt_both(turn.value, frames_[at(joint)].slide, {.turn_rule = turn.rule});
      const model::Quantity turn = frames_[at(joint)].turn;
      for (const Candidate& slide : candidates_.slides(joint, turn, frames_))
        attempt_both(turn, slide.value, {.slide_rule = slide.rule});
    }
    if (!formulation_.turn_inertia) return;
    attempt_both(frames_[at(joint)].turn, frames_[at(joint)].slide, {});
    if (tree_.parent_joint_of(joint) < 0) return;
    for (const bool parent_turns : {true, false})
      attempt_both(frames_[at(joint)].turn, frames_[at(joint)].slide, {.parent_turns = parent_turns});
  }
};

}  // namespace

LinkFrames cheap_frames(const KinematicTree& tree, const Formulation& formulation, const TraceOf& trace) {
  if (formulation.effort <= 0 || (!formulation.choose_frames && !formulation.turn_inertia)) return formulation.frames;
  return Search(tree, formulation, trace).run();
}

}  // namespace robcogen::algorithm
