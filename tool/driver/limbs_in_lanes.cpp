#include "driver/limbs_in_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithm/formulation/congruent_limbs.h"
#include "pass/lanes/pack_lanes.h"
#include "pass/passes.h"
#include "support/parallel.h"
#include "symbolic/cost.h"

namespace robcogen::driver {
namespace {

using symbolic::Program;

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
  // clearly faster than the program without lanes.
  std::optional<pass::Packed> choose() {
    add(function_.program);
    if (function_.results && !has_parameters_) {
      if (function_.is_first_choice) add_congruent(Formulated::for_lanes);
      // What the search for link frames gains in scalar programs may be a loss in lanes.
      if (has_formulation(function_) && formulations_.are_searched()) {
        add(made(Formulated::unsearched));
        add_congruent(Formulated::unsearched_for_lanes);
      }
    }
    std::stable_sort(found_.begin(), found_.end(), [](const pass::Packed& a, const pass::Packed& b) {
      return predicted_time(a.program) < predicted_time(b.program);
    });
    for (pass::Packed& packed : found_)
      if (!function_.results || function_.results->are_kept_by(packed.program)) return std::move(packed);
    return std::nullopt;
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
  std::vector<pass::Packed> found_;

  void add(const Program& program) {
    if (auto packed = pass::pack_lanes_within(program, classes_, time_)) found_.push_back(std::move(*packed));
  }

  Program made(Formulated formulated) {
    return pass::run(traced(function_, formulations_.of(formulated)).program, passes_);
  }

  // The program of a formulation in which congruent limbs fold in the same way, if it is a different program.
  void add_congruent(Formulated formulated) {
    algorithm::FormulationChoices& choices = formulations_.of(formulated);
    if (!algorithm::may_fold_like_others(*function_.declared, choices)) return;
    Program program = traced(function_, choices).program;
    if (algorithm::folds_like_others(program)) add(pass::with_plain_numbers(pass::run(std::move(program), passes_)));
  }
};

}  // namespace

Functions pack_lanes(const Robot& robot, Functions functions, Formulations& formulations, const Passes& passes) {
  const std::vector<algorithm::LimbsInLanes> limbs = algorithm::limbs_in_lanes(robot.tree);
  if (limbs.empty()) return functions;
  for_each_index(functions.list.size(), [&](std::size_t i) {
    Function& function = functions.list[i];
    LanesOfFunction lanes(function, limbs, robot.tree, formulations, passes);
    std::optional<pass::Packed> packed = lanes.choose();
    if (!packed) {
      function.without_lanes = lanes.reason();
      return;
    }
    for (std::size_t c = 0; c < limbs.size(); ++c)
      if (packed->in_lanes[c]) function.limbs_in_lanes.push_back(fmt::format("{}", fmt::join(limbs[c].names, ", ")));
    function.in_lanes = std::move(packed->program);
  });
  return functions;
}

}  // namespace robcogen::driver
