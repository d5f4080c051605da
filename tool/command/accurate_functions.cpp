#include "command/accurate_functions.h"

#include "pass/passes.h"
#include "support/lazy.h"
#include "support/parallel.h"

namespace robcogen::command {
namespace {

using algorithm::Formulation;
using algorithm::RobotFunction;
using symbolic::AccurateResults;

// The functions of one group by simpler formulations, traced when one of them is first needed.
class SimplerFunctions {
 public:
  SimplerFunctions(
      const model::KinematicTree& tree,
      const model::DesiredTransforms& desired,
      const std::string& group,
      const Formulation& formulation)
      : tree_(tree), desired_(desired), group_(group), unsearched_(formulation) {
    unsearched_.effort = 0;
  }

  RobotFunction unsearched(std::size_t index) { return of(functions_unsearched_, unsearched_)[index]; }
  RobotFunction plain(std::size_t index) { return of(functions_plain_, algorithm::plain_formulation())[index]; }

 private:
  using Functions = std::vector<RobotFunction>;
  const model::KinematicTree& tree_;
  const model::DesiredTransforms& desired_;
  const std::string& group_;
  Formulation unsearched_;
  Lazy<Functions> functions_unsearched_, functions_plain_;

  const Functions& of(Lazy<Functions>& list, const Formulation& formulation) {
    return list.get([&] { return algorithm::functions(tree_, desired_, group_, formulation); });
  }
};

RobotFunction optimised(RobotFunction function, const std::vector<std::string>& passes) {
  function.program = pass::run(std::move(function.program), passes);
  return function;
}

// Sets the rounding errors of the function; returns whether they are small enough.
bool measure(RobotFunction& function, const AccurateResults& results) {
  const symbolic::Accuracy accuracy = results.accuracy_of(function.program);
  function.error = accuracy.error;
  return accuracy.is_kept;
}

// The function at `index` of its group.
AccurateFunction accurate(
    RobotFunction traced,
    std::size_t index,
    const symbolic::Program& plain,
    const std::vector<double>& parameters,
    const std::vector<std::string>& passes,
    SimplerFunctions& simpler) {
  AccurateFunction result;
  result.results = std::make_shared<const AccurateResults>(plain, parameters);
  result.function = optimised(std::move(traced), passes);
  if (measure(result.function, *result.results)) return result;
  result.is_as_traced = false;
  result.function = optimised(simpler.unsearched(index), passes);
  if (measure(result.function, *result.results)) return result;
  result.function = optimised(simpler.plain(index), passes);
  if (measure(result.function, *result.results)) return result;
  result.function = simpler.plain(index);
  measure(result.function, *result.results);
  return result;
}

}  // namespace

std::vector<AccurateFunction> accurate_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::vector<std::string>& groups,
    std::vector<std::vector<RobotFunction>> of_groups,
    const Formulation& formulation,
    const std::vector<std::string>& passes) {
  std::vector<std::vector<symbolic::Program>> plain(groups.size());
  for_each_index(groups.size(), [&](std::size_t g) { plain[g] = algorithm::plain_programs(tree, groups[g]); });
  struct Place {
    std::size_t group, index;
  };
  std::vector<Place> places;
  std::vector<std::unique_ptr<SimplerFunctions>> simpler;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    simpler.push_back(std::make_unique<SimplerFunctions>(tree, desired, groups[g], formulation));
    for (std::size_t i = 0; i < of_groups[g].size(); ++i) places.push_back({g, i});
  }
  const std::vector<double> parameters = algorithm::parameter_values(tree);
  std::vector<AccurateFunction> result(places.size());
  for_each_index(places.size(), [&](std::size_t k) {
    const auto [g, i] = places[k];
    RobotFunction& traced = of_groups[g][i];
    // Functions that no formulation has a part in are measured by what they are before the passes.
    const symbolic::Program reference = plain[g].empty() ? traced.program : std::move(plain[g][i]);
    result[k] = accurate(std::move(traced), i, reference, parameters, passes, *simpler[g]);
  });
  return result;
}

}  // namespace robcogen::command
