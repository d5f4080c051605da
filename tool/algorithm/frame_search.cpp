#include "algorithm/frame_search.h"

#include <algorithm>

#include "algorithm/frame_candidates.h"
#include "algorithm/limb_view.h"
#include "symbolic/count.h"

namespace robcogen::algorithm {
namespace {

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

// Statements that may be traced at effort 1.
constexpr long kStatements = 4'000'000;
constexpr int kRounds = 2;

class Search {
 public:
  Search(const model::KinematicTree& tree, const Formulation& formulation, const TraceOf& trace)
      : tree_(tree),
        formulation_(formulation),
        trace_(trace),
        candidates_(tree, formulation),
        numbers_(candidates_.numbers()),
        frames_(formulation.frames),
        left_(kStatements * formulation.effort) {
    if (frames_.empty()) frames_.resize(tree.joints.size());
  }

  LinkFrames run() {
    const std::vector<int> joints = tree_.topological();
    for (int round = 0; round < kRounds; ++round) {
      bool better = false;
      for (const int j : joints) better |= improve(j);
      if (!better) break;
    }
    return frames_;
  }

 private:
  const model::KinematicTree& tree_;
  const Formulation& formulation_;
  const TraceOf& trace_;
  FrameCandidates candidates_;
  std::shared_ptr<const LinkNumbers> numbers_;       // of a robot without parameters
  std::shared_ptr<const LinkNumbers> view_numbers_;  // of the view at hand
  LinkFrames frames_;
  long left_;

  // Of the part of the robot that a limb belongs to, in these frames.
  int cost(const LimbView& view, const LinkFrames& frames) {
    Formulation choice = formulation_;
    choice.is_draft = true;
    choice.numbers = view_numbers_;
    choice.frames.clear();
    for (const int j : view.joints) choice.frames.push_back(frames[at(j)]);
    const symbolic::Program program = trace_(view.tree, choice);
    left_ -= static_cast<long>(program.statements.size());
    return symbolic::work(program);
  }

  // The numbers of the view's joints and links.
  std::shared_ptr<const LinkNumbers> numbers_of(const LimbView& view) const {
    if (!numbers_) return nullptr;
    LinkNumbers result;
    result.masses.push_back(numbers_->masses[0]);
    for (const int j : view.joints) {
      result.placements.push_back(numbers_->placements[at(j)]);
      result.masses.push_back(numbers_->masses[at(tree_.joints[at(j)].child)]);
    }
    return std::make_shared<const LinkNumbers>(std::move(result));
  }

  bool improve(int joint) {
    if (left_ <= 0) return false;
    const LimbView view = limb_view(tree_, joint);
    view_numbers_ = numbers_of(view);
    int best = cost(view, frames_);
    const int before = best;
    const auto attempt = [&](const LinkFrames& frames) {
      if (left_ <= 0) return;
      const int c = cost(view, frames);
      if (c >= best) return;
      best = c;
      frames_ = frames;
    };
    const auto with = [&](int j, const LinkFrame& frame) {
      LinkFrames frames = frames_;
      frames[at(j)] = frame;
      return frames;
    };
    if (formulation_.choose_frames) {
      for (const model::Quantity& turn : candidates_.turns(joint, frames_)) {
        for (const model::Quantity& slide : candidates_.slides(joint, turn, frames_)) {
          for (const bool turns : {true, false}) {
            if (!turns && !formulation_.turn_inertia) continue;
            attempt(with(joint, {turn, slide, turns}));
          }
        }
      }
    }
    if (formulation_.turn_inertia) {
      const int parent = tree_.parent_joint_of(joint);
      for (const bool own : {true, false}) {
        LinkFrame frame = frames_[at(joint)];
        frame.turns_with_joint = own;
        attempt(with(joint, frame));
        if (parent < 0) continue;
        for (const bool parents : {true, false}) {
          LinkFrames frames = with(joint, frame);
          frames[at(parent)].turns_with_joint = parents;
          attempt(frames);
        }
      }
    }
    return best < before;
  }
};

}  // namespace

LinkFrames cheap_frames(const model::KinematicTree& tree, const Formulation& formulation, const TraceOf& trace) {
  if (formulation.effort <= 0 || (!formulation.choose_frames && !formulation.turn_inertia)) return formulation.frames;
  return Search(tree, formulation, trace).run();
}

}  // namespace robcogen::algorithm
