#include "model/formula_closures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "model/assemblies.h"
#include "model/parallelogram.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

// A loop is stretched if the sine of the angle between the directions of its dependent joints is below this.
constexpr double kStretched = 1e-4;
constexpr double kWellDetermined = 0.1;

// The number of dependent joints that are driven, the number of other loops that share dependent joints, whether the
// dependent joints are badly determined, and how early they stand in the document. Lower is better.
using Score = std::tuple<int, int, bool, int>;

// A loop of the group, and the sets of joints that a formula can make dependent, best first.
struct Alternatives {
  Closure closure;  // without the dependent joints
  std::optional<Parallelogram> parallelogram;
  std::vector<std::pair<Score, std::vector<int>>> dependents;
};

// Chooses the dependent joints of loops that share joints. Each loop in turn takes the best joints that the loops
// before it have left. If a later loop is left with none, or loops depend on one another cyclically, the loops before
// it take their next best joints.
class FormulaSearch {
 public:
  FormulaSearch(LoopContext& context, const std::vector<int>& loops) : context_(context), loops_(loops) {
    for (const int loop : loops)
      for (const int joint : joints_of(tree().loops[at(loop)])) ++loops_of_[joint];
  }

  std::optional<std::vector<Closure>> run() {
    const std::size_t errors_before = context_.diagnostics.error_count();
    for (const int loop : loops_)
      if (!add_alternatives(loop)) return std::nullopt;
    if (context_.diagnostics.error_count() > errors_before) return std::vector<Closure>();
    if (!choose_from(0)) return std::nullopt;
    for (const Alternatives& loop : alternatives_)
      if (loop.parallelogram && loop.parallelogram->is_flat()) warn_of_flat(tree().loops[at(loop.closure.loop())]);
    return sorted_;
  }

 private:
  LoopContext& context_;
  const std::vector<int>& loops_;
  std::map<int, int> loops_of_;  // by joint: the number of loops that it is part of
  std::vector<Alternatives> alternatives_;
  std::map<int, int> followed_;    // dependent joint -> index of its closure
  std::vector<Closure> closures_;  // of the loops decided so far
  std::vector<Closure> sorted_;
  int trials_ = 0;
  bool has_gone_back_ = false;  // the search has backtracked

  const KinematicTree& tree() const { return context_.tree; }

  // Returns false if another method may close the loop.
  bool add_alternatives(int index) {
    const LoopJoint& loop = tree().loops[at(index)];
    if (loop.type == LoopType::slider || loop.type == LoopType::weld) return false;
    Alternatives found;
    Closure& closure = found.closure;
    closure.loops = {index};
    closure.method = loop.type == LoopType::distance ? Closure::Method::distance : Closure::Method::planar;
    if (closure.method == Closure::Method::planar) {
      const PlaneFault fault = find_plane(tree(), loop, context_.parameters, closure);
      if (fault.is_in_space) return false;
      if (!fault.code.empty()) {
        context_.report(loop, fault);
        return true;
      }
    }
    std::vector<int> free = joints_of(loop);
    std::erase_if(free, [&](int joint) { return !context_.is_free(joint); });
    const std::size_t wanted = closure.method == Closure::Method::planar ? 2 : 1;
    if (free.size() < wanted) {
      if (loops_.size() > 1) return false;
      // A loop of joints about one axis removes none.
      if (dependents_of(loop, joints_of(loop), wanted, std::nullopt, closure).empty()) return false;
      report_over_constrained(loop, wanted, free);
      return true;
    }
    found.parallelogram = find_parallelogram(tree(), loop, context_.parameters, closure);
    if (found.parallelogram && !is_assembled_as(*found.parallelogram, loop, free, closure)) found.parallelogram.reset();
    found.dependents = dependents_of(loop, free, wanted, found.parallelogram, closure);
    if (found.dependents.empty()) return false;
    alternatives_.push_back(std::move(found));
    return true;
  }

  void report_over_constrained(const LoopJoint& loop, std::size_t wanted, const std::vector<int>& free) {
    context_.diagnostics
        .error(
            "loop-over-constrained", loop.place,
            fmt::format(
                "loop '{}' removes {}, but {} of its joints can follow the others", loop.name,
                wanted == 1 ? "one degree of freedom" : "two degrees of freedom", free.empty() ? "none" : "only one"))
        .hint = context_.hint_to_free(joints_of(loop));
  }

  // Whether the loop is assembled as a parallelogram. If the document gives a position for assembly, the links may be
  // crossed there.
  bool is_assembled_as(
      const Parallelogram& parallelogram,
      const LoopJoint& loop,
      const std::vector<int>& free,
      Closure closure) const {
    if (!context_.has_start(joints_of(loop))) return true;
    const auto found = dependents_of(loop, free, 2, std::nullopt, closure);
    if (found.empty()) return true;
    closure.dependents = found.front().second;
    std::vector<double> q = context_.start();
    model::close(tree(), closure, q, context_.parameters);
    return parallelogram.holds(q);
  }

  void warn_of_flat(const LoopJoint& loop) {
    if (context_.has_start(joints_of(loop))) return;
    context_.diagnostics
        .warning(
            "loop-flat", loop.place,
            fmt::format(
                "loop '{}' is flat at q = 0: it is treated as a parallelogram, whose opposite links stay parallel, not "
                "as crossed links",
                loop.name))
        .hint = context_.hint_to_assemble(joints_of(loop), "the loop is not flat");
  }

  std::vector<std::pair<Score, std::vector<int>>> dependents_of(
      const LoopJoint& loop,
      const std::vector<int>& free,
      std::size_t wanted,
      const std::optional<Parallelogram>& parallelogram,
      const Closure& closure) const {
    const LoopPosture start = posture(tree(), loop, context_.start(), context_.parameters);
    const double length = evaluate(loop.length, context_.parameters);
    std::vector<std::pair<Score, std::vector<int>>> result;
    const auto consider = [&](std::vector<int> joints) {
      Closure trial = closure;
      trial.dependents = std::move(joints);
      const double condition = parallelogram ? (parallelogram->determines(trial.dependents) ? 1.0 : 0.0)
                                             : conditioning(trial, start, error_of(trial, start, length));
      if (!(condition > kStretched) || slides(trial.dependents) > 1) return;
      Score score = {0, 0, condition < kWellDetermined, 0};
      for (const int joint : trial.dependents) {
        std::get<0>(score) += context_.is_driven(joint) ? 1 : 0;
        std::get<1>(score) += loops_of_.at(joint) - 1;
        std::get<3>(score) -= joint;
      }
      result.emplace_back(score, std::move(trial.dependents));
    };
    for (std::size_t i = 0; i < free.size(); ++i) {
      if (wanted == 1) consider({free[i]});
      for (std::size_t k = i + 1; wanted == 2 && k < free.size(); ++k) consider({free[i], free[k]});
    }
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return result;
  }

  int slides(const std::vector<int>& joints) const {
    return static_cast<int>(std::count_if(
        joints.begin(), joints.end(), [&](int j) { return tree().joints[at(j)].type == JointType::prismatic; }));
  }

  // Chooses the dependent joints of this loop of the group and of those after it. Returns whether all loops can be
  // solved one after another.
  bool choose_from(std::size_t loop) {
    constexpr int kMaxTrials = 100'000;
    if (loop == alternatives_.size()) return (!has_gone_back_ || drives_lead()) && put_in_order();
    for (const auto& [score, joints] : alternatives_[loop].dependents) {
      if (++trials_ > kMaxTrials) return false;
      const auto is_followed = [&](int joint) { return followed_.contains(joint); };
      if (std::any_of(joints.begin(), joints.end(), is_followed)) continue;
      Closure closure = alternatives_[loop].closure;
      closure.dependents = joints;
      if (const auto& parallelogram = alternatives_[loop].parallelogram) closure.shares = parallelogram->shares(joints);
      closures_.push_back(std::move(closure));
      for (const int joint : joints) followed_.insert({joint, static_cast<int>(loop)});
      if (choose_from(loop + 1)) return true;
      for (const int joint : joints) followed_.erase(joint);
      closures_.pop_back();
      has_gone_back_ = true;
    }
    return false;
  }

  // Whether no more driven joints are dependent than necessary. If more are, iteration closes the loops instead, and
  // these joints stay independent.
  bool drives_lead() const {
    std::set<int> free;
    for (const Alternatives& loop : alternatives_)
      for (const auto& [score, joints] : loop.dependents) free.insert(joints.begin(), joints.end());
    const auto is_driven = [&](int joint) { return context_.is_driven(joint); };
    const auto undriven = std::count_if(free.begin(), free.end(), std::not_fn(is_driven));
    const auto driven_followers = std::count_if(
        followed_.begin(), followed_.end(), [&](const auto& followed) { return is_driven(followed.first); });
    return driven_followers <= std::max<std::ptrdiff_t>(0, std::ssize(followed_) - undriven);
  }

  // Orders the closures so that each comes after those that determine its joints. Returns whether there is such an
  // order.
  bool put_in_order() {
    sorted_.clear();
    std::vector<bool> done(closures_.size());
    while (sorted_.size() < closures_.size()) {
      bool progress = false;
      for (std::size_t k = 0; k < closures_.size(); ++k) {
        if (done[k] || !is_ready(static_cast<int>(k), done)) continue;
        sorted_.push_back(closures_[k]);
        done[k] = progress = true;
      }
      if (!progress) return false;
    }
    return true;
  }

  bool is_ready(int closure, const std::vector<bool>& done) const {
    const std::vector<int> joints = joints_of(tree().loops[at(closures_[at(closure)].loop())]);
    return std::all_of(joints.begin(), joints.end(), [&](int joint) {
      const auto other = followed_.find(joint);
      return other == followed_.end() || other->second == closure || done[at(other->second)];
    });
  }
};

// Wraps an angle to [-PI, PI].
double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::acos(-1.0));
}

// Moves the dependent joints to a position in which the loop closes with the other sign of the root, as near as
// possible to the present position. Searches from starts all around, in one or two dependent joints. Returns whether
// there is such a position.
bool assemble_other_way(LoopContext& context, Closure& closure, std::vector<double>& q) {
  const KinematicTree& tree = context.tree;
  const LoopJoint& loop = tree.loops[at(closure.loop())];
  const double size = size_of(posture(tree, loop, q, context.parameters));
  const std::vector<double> drawn = q;
  std::optional<std::vector<double>> best;
  double least = 0.0;
  const auto turns_there = [&](int joint) { return turns(tree.joints[at(joint)].type); };
  const auto consider = [&](std::vector<double> start) {
    const double gap = model::close(tree, closure, start, context.parameters);
    const LoopPosture there = posture(tree, loop, start, context.parameters);
    if (!(gap <= kClosed * size) || branch_of(tree, closure, there) == closure.branch) return;
    double moved = 0.0;
    for (const int joint : closure.dependents) {
      if (turns_there(joint)) start[at(joint)] = wrapped(start[at(joint)]);
      moved += std::abs(start[at(joint)] - drawn[at(joint)]) / (turns_there(joint) ? 1.0 : size);
    }
    if (!best || moved < least) best = start, least = moved;
  };
  constexpr int kStarts = 12;
  const auto start_of = [&](int joint, int k) {
    const double share = 2.0 * k / kStarts - 1.0;
    return drawn[at(joint)] + share * (turns_there(joint) ? std::acos(-1.0) : 2.0 * size);
  };
  for (int i = 0; i < kStarts; ++i)
    for (int k = 0; k < (closure.dependents.size() > 1 ? kStarts : 1); ++k) {
      std::vector<double> start = drawn;
      start[at(closure.dependents.front())] = start_of(closure.dependents.front(), i);
      if (closure.dependents.size() > 1) start[at(closure.dependents.back())] = start_of(closure.dependents.back(), k);
      consider(std::move(start));
    }
  if (!best) return false;
  q = *best;
  closure.branch = -closure.branch;
  return true;
}

}  // namespace

std::optional<std::vector<Closure>> formula_closures(LoopContext& context, const std::vector<int>& loops) {
  return FormulaSearch(context, loops).run();
}

void assemble_by_formula(LoopContext& context, Closure& closure, std::vector<double>& q) {
  const LoopJoint& loop = context.tree.loops[at(closure.loop())];
  const std::vector<double> start = q;
  const double error = model::close(context.tree, closure, q, context.parameters);
  const LoopPosture now = posture(context.tree, loop, q, context.parameters);
  const double length = evaluate(loop.length, context.parameters);
  if (!(error <= kClosed * size_of(now))) {
    PlaneFault fault = open_loop(loop, gap_of(loop, now, length, error), context.where(joints_of(loop)));
    fault.hint = context.hint_to_close(joints_of(loop));
    explain_open(
        context, find_assemblies(context, closure.loops, start, closure.dependents),
        fmt::format("loop '{}' is", loop.name), context.where(joints_of(loop)), fault);
    context.report(loop, fault);
    return;
  }
  if (conditioning(closure, now, error_of(closure, now, length)) < kStretched) {
    context.diagnostics
        .error(
            "loop-stretched", loop.place,
            fmt::format(
                "loop '{}' is stretched {}: its assembly, and the motions of {}, are undefined", loop.name,
                context.where(joints_of(loop)), context.quoted(closure.dependents)))
        .hint = context.hint_to_assemble(joints_of(loop), "the loop is not stretched");
    return;
  }
  closure.branch = branch_of(context.tree, closure, now);
  if (loop.takes_other_branch && !assemble_other_way(context, closure, q))
    context.diagnostics.error(
        "loop-branch", loop.place,
        fmt::format("loop '{}' has only one assembly {}: the drawn one", loop.name, context.where(joints_of(loop))));
}

}  // namespace robcogen::model
