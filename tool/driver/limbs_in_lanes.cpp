#include "driver/limbs_in_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pass/lanes/pack_lanes.h"
#include "pass/passes.h"
#include "symbolic/cost.h"

namespace robcogen::driver {
namespace {

using symbolic::Program;

// A program with lanes.
struct InLanes {
  pass::Packed packed;
  int starts = 0;
  std::string method;  // how it is computed
};

class LanesOfFunction {
 public:
  LanesOfFunction(
      const Function& function,
      const std::vector<algorithm::LimbsInLanes>& limbs,
      const model::KinematicTree& tree,
      Formulations& formulations,
      const Passes& passes)
      : function_(function),
        formulations_(formulations),
        passes_(passes),
        has_parameters_(!tree.parameters.empty()),
        time_(predicted_time(function.program)) {
    for (const algorithm::LimbsInLanes& c : limbs) classes_.push_back(limb_inputs(tree, c, function.program));
  }

  // The fastest program with lanes that keeps the digits of the plain formulation; nullopt if there is none that is
  // clearly faster than the program without lanes. If all others lose digits, those without searched link frames are
  // candidates, too.
  std::optional<InLanes> choose() {
    add(function_.program, function_.method);
    const bool has_others = function_.results && !has_parameters_;
    if (has_others && function_.is_first_choice) add_congruent(Formulated::for_lanes);
    std::optional<InLanes> best = fastest();
    if (best || !has_others || !has_formulation(function_) || !formulations_.are_searched()) return best;
    add_unsearched();
    return fastest();
  }

  // Why there is no such program; empty if no two congruent limbs take part.
  std::string reason() const {
    if (!pass::reads_congruent_limbs(function_.program, classes_)) return "";
    return found_.empty() ? "lanes would not be clearly faster" : "lanes would lose digits";
  }

 private:
  const Function& function_;
  Formulations& formulations_;
  const Passes& passes_;
  const bool has_parameters_;
  const int time_;
  std::vector<pass::InputTuples> classes_;
  std::vector<InLanes> found_;

  void add(const Program& program, const std::string& method) {
    std::optional<pass::Packed> packed = pass::pack_lanes_within(program, classes_, time_);
    if (!packed) return;
    const int time = starts(packed->program);
    found_.push_back({std::move(*packed), time, method});
  }

  // Adds the program of a formulation in which congruent limbs fold in the same way, if it is a different program.
  bool add_congruent(Formulated formulated) {
    algorithm::FormulationChoices& choices = formulations_.of(formulated);
    if (!algorithm::may_fold_like_others(*function_.declared, choices)) return false;
    symbolic::Function other = traced(function_, choices);
    if (!algorithm::folds_like_others(other.program)) return false;
    const Program program = pass::with_plain_numbers(pass::run(std::move(other.program), passes_));
    add(program, other.method);
    return true;
  }

  void add_unsearched() {
    if (add_congruent(Formulated::unsearched_for_lanes)) return;
    symbolic::Function other = traced(function_, formulations_.of(Formulated::unsearched));
    add(pass::run(std::move(other.program), passes_), other.method);
  }

  std::optional<InLanes> fastest() {
    std::stable_sort(
        found_.begin(), found_.end(), [](const InLanes& a, const InLanes& b) { return a.starts < b.starts; });
    for (InLanes& found : found_)
      if (!function_.results || function_.results->are_kept_by(found.packed.program)) return std::move(found);
    return std::nullopt;
  }
};

}  // namespace

int starts(const Program& program) {
  return weighted(symbolic::cost(program), symbolic::kStarts);
}

void pack_lanes(
    const Robot& robot,
    const std::vector<algorithm::LimbsInLanes>& limbs,
    Function& function,
    Formulations& formulations,
    const Passes& passes) {
  if (limbs.empty() || function.in_lanes || !function.without_lanes.empty()) return;
  LanesOfFunction lanes(function, limbs, robot.tree, formulations, passes);
  std::optional<InLanes> best = lanes.choose();
  if (!best) {
    function.without_lanes = lanes.reason();
    return;
  }
  for (std::size_t c = 0; c < limbs.size(); ++c)
    if (best->packed.in_lanes[c]) function.limbs_in_lanes.push_back(fmt::format("{}", fmt::join(limbs[c].names, ", ")));
  function.in_lanes = std::move(best->packed.program);
  function.method = std::move(best->method);
}

}  // namespace robcogen::driver
