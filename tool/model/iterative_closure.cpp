#include "model/iterative_closure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/assemblies.h"
#include "model/loop_cluster.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

class IterativeSearch {
 public:
  IterativeSearch(LoopContext& context, const std::vector<int>& loops, std::vector<double>& q)
      : context_(context), loops_(loops), cluster_(context.tree, loops, context.parameters), start_(q), q_(q) {}

  std::optional<Closure> run() {
    const std::vector<int> candidates = in_order_of_preference();
    Closure closure;
    closure.loops = loops_;
    closure.method = Closure::Method::iterative;
    // Choose the dependent joints at the position as drawn, where the loops may not be closed exactly; then again where
    // they are closed.
    closure.dependents = cluster_.following(q_, candidates);
    double gap = cluster_.close(q_, closure.dependents);
    const int rank = cluster_.rank(q_);
    if (is_closed(gap) && rank < static_cast<int>(closure.dependents.size()))
      closure.dependents = cluster_.following(q_, candidates);
    if (!is_closed(gap)) return report_open(gap);
    const int joints = static_cast<int>(cluster_.joints().size());
    const int follow = static_cast<int>(closure.dependents.size());
    if (follow < rank)
      return report(
          "loop-over-constrained",
          fmt::format(
              "{} {}, but only {} of {} joints can follow the others", removes(), freedoms(rank), follow, their()),
          context_.hint_to_free(cluster_.joints()));
    if (rank == joints)
      return report(
          "loop-over-constrained", fmt::format("{} all {} of {} joints", removes(), freedoms(rank), their()),
          "remove a loop, or add a joint");
    if (!moves(closure.dependents, rank)) return std::nullopt;
    return closure;
  }

 private:
  LoopContext& context_;
  const std::vector<int>& loops_;
  LoopCluster cluster_;
  const std::vector<double> start_;
  std::vector<double>& q_;

  bool is_closed(double gap) const { return gap <= kClosed * cluster_.size(q_); }
  const LoopJoint& first() const { return context_.tree.loops[at(loops_.front())]; }

  std::string names() const {
    std::string text;
    for (const int loop : loops_) text += (text.empty() ? "'" : ", '") + context_.tree.loops[at(loop)].name + "'";
    return text;
  }
  bool is_one() const { return loops_.size() == 1; }
  std::string removes() const { return subject() + (is_one() ? " removes" : " remove"); }
  std::string subject() const { return (is_one() ? "loop " : "loops ") + names(); }
  std::string their() const { return is_one() ? "its" : "their"; }
  std::string where() const { return context_.where(cluster_.joints()); }
  static std::string freedoms(int count) {
    return fmt::format("{} {} of freedom", count, count == 1 ? "degree" : "degrees");
  }

  std::nullopt_t report(const std::string& code, const std::string& message, const std::string& hint) {
    context_.report(first(), {code, message, hint});
    return std::nullopt;
  }

  // Returns why a loop that may be meant to be planar is not planar; empty if this does not apply.
  std::string reason_in_space() const {
    if (!is_one() || (first().type != LoopType::hinge && first().type != LoopType::point)) return "";
    Closure unused;
    const PlaneFault fault = find_plane(context_.tree, first(), context_.parameters, unused);
    return fault.is_in_space ? fault.message : "";
  }

  std::nullopt_t report_open(double gap) {
    const std::string reason = reason_in_space();
    if (std::isinf(gap))
      return report(
          "loop-cannot-close", fmt::format("{} would close {} with frames half a turn apart", subject(), where()),
          "turn one of the frames by PI");
    if (is_one()) {
      const LoopPosture now = posture(context_.tree, first(), q_, context_.parameters);
      const double length = evaluate(first().length, context_.parameters);
      PlaneFault fault = open_loop(first(), gap_of(first(), now, length, gap), where());
      fault.hint = reason.empty() ? context_.hint_to_close(cluster_.joints()) : reason;
      explain(fault, reason.empty());
      context_.report(first(), fault);
      return std::nullopt;
    }
    PlaneFault fault = {
        "loop-cannot-close",
        fmt::format("loops {} do not close {}: they remain open by {:.3g} m", names(), where(), gap),
        context_.hint_to_close(cluster_.joints())};
    explain(fault, true);
    context_.report(first(), fault);
    return std::nullopt;
  }

  // Adds how the loops can be assembled to the report that they are open.
  void explain(PlaneFault& fault, bool may_be_meant) const {
    if (!may_be_meant) return;
    const LoopAssemblies found = find_assemblies(context_, loops_, start_, in_order_of_preference());
    explain_open(context_, found, subject() + (is_one() ? " is" : " are"), where(), fault);
  }

  // Joints without drives come first; within each kind, those declared last come first.
  std::vector<int> in_order_of_preference() const {
    std::vector<int> candidates = cluster_.joints();
    std::erase_if(candidates, [&](int joint) { return !context_.is_free(joint); });
    std::stable_sort(candidates.begin(), candidates.end(), [&](int a, int b) {
      const bool is_a_driven = context_.is_driven(a), is_b_driven = context_.is_driven(b);
      return is_a_driven != is_b_driven ? is_b_driven : a > b;
    });
    return candidates;
  }

  // Whether the loops stay closed, with the same rank, when the independent joints move a little.
  bool moves(const std::vector<int>& following, int rank) {
    constexpr int kDirections = 5, kHalvings = 4;
    std::minstd_rand engine(1);
    std::uniform_real_distribution<double> any(-0.1, 0.1);
    bool has_moved = false;
    for (int direction = 0; direction < kDirections; ++direction) {
      std::vector<double> step(q_.size());
      for (const int joint : cluster_.joints())
        if (std::find(following.begin(), following.end(), joint) == following.end()) step[at(joint)] = any(engine);
      for (int halving = 0; halving <= kHalvings; ++halving) {
        std::vector<double> q = q_;
        for (std::size_t j = 0; j < q.size(); ++j) q[j] += std::ldexp(step[j], -halving);
        if (!is_closed(cluster_.close(q, following))) continue;
        has_moved = true;
        if (const int nearby = cluster_.rank(q); nearby != rank) {
          report(
              "loop-stretched",
              fmt::format(
                  "{} {} {}, but {} nearby: the motions of {} are undefined", removes(), freedoms(rank), where(),
                  nearby, following.empty() ? "the joints that follow" : context_.quoted(following)),
              context_.hint_to_assemble(
                  cluster_.joints(), is_one() ? "the loop is not stretched" : "the loops are not stretched"));
          return false;
        }
        break;
      }
    }
    if (!has_moved)
      report(
          "loop-over-constrained",
          fmt::format(
              "{} {} {}, but {} joints close {} only there: {} stretched, or cannot move", removes(), freedoms(rank),
              where(), their(), is_one() ? "it" : "them", is_one() ? "it is" : "they are"),
          reason_in_space().empty() ? context_.hint_to_assemble(cluster_.joints(), "the links are not stretched") +
                                          "; axes that are meant to be parallel or to intersect must do so exactly"
                                    : reason_in_space());
    return has_moved;
  }
};

}  // namespace

std::optional<Closure> iterative_closure(LoopContext& context, const std::vector<int>& loops, std::vector<double>& q) {
  for (const int index : loops) {
    const LoopJoint& loop = context.tree.loops[at(index)];
    if (!loop.takes_other_branch) continue;
    context.diagnostics
        .error(
            "loop-branch", loop.place,
            fmt::format("loop '{}' is closed by Newton's method, which has no other branch", loop.name))
        .hint = "turn the placements of its joints to the assembly that is wanted: the closest one is taken";
    return std::nullopt;
  }
  return IterativeSearch(context, loops, q).run();
}

}  // namespace robcogen::model
