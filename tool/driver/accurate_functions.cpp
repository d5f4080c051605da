#include "driver/accurate_functions.h"

#include <map>
#include <utility>

#include "driver/derivatives.h"
#include "pass/passes.h"
#include "support/lazy.h"
#include "support/parallel.h"
#include "symbolic/cost.h"

namespace robcogen::driver {
namespace {

using algorithm::Formulation;
using algorithm::RobotFunction;
using symbolic::AccurateResults;

// The functions of one group in simpler formulations, which are traced when one of them is first needed.
class SimplerFunctions {
 public:
  SimplerFunctions(const Robot& robot, std::string group, const Formulation& formulation)
      : robot_(robot), group_(std::move(group)), unsearched_(formulation) {
    unsearched_.effort = 0;
    plain_programs = traced_plainly();
  }

  // Empty for groups that do not depend on the formulation.
  std::vector<symbolic::Program> plain_programs;

  RobotFunction unsearched(std::size_t index) { return of(functions_unsearched_, unsearched_)[index]; }
  RobotFunction plain(std::size_t index) { return of(functions_plain_, algorithm::plain_formulation())[index]; }

 private:
  using List = std::vector<RobotFunction>;
  const Robot& robot_;
  std::string group_;
  Formulation unsearched_;
  Lazy<List> functions_unsearched_, functions_plain_;

  const List& of(Lazy<List>& list, const Formulation& formulation) {
    return list.get([&] { return functions(formulation); });
  }

  bool are_derivatives() const { return group_ == kDerivativesGroup; }

  List functions(const Formulation& formulation) const {
    if (!are_derivatives()) return algorithm::functions(robot_.tree, robot_.desired, group_, formulation);
    algorithm::FormulationChoices choices(robot_.tree, formulation);
    return derivative_functions(robot_, {}, choices);
  }

  std::vector<symbolic::Program> traced_plainly() const {
    if (!are_derivatives()) return algorithm::plain_programs(robot_.tree, robot_.desired, group_);
    Formulation formulation = algorithm::plain_formulation();
    formulation.is_draft = true;
    std::vector<symbolic::Program> programs;
    for (RobotFunction& f : functions(formulation)) programs.push_back(std::move(f.program));
    return programs;
  }
};

RobotFunction optimised(RobotFunction function, const std::vector<std::string>& passes) {
  function.program = pass::run(std::move(function.program), passes);
  return function;
}

std::vector<std::string> without(std::vector<std::string> passes, const std::string& name) {
  std::erase(passes, name);
  return passes;
}

// Sets the rounding errors of the function; returns whether they are small enough.
bool measure(RobotFunction& function, const AccurateResults& results) {
  const symbolic::Accuracy accuracy = results.accuracy_of(function.program);
  function.error = accuracy.error;
  return accuracy.is_kept;
}

// Runs the passes on the function, which is at `index` of its group.
void run_on(
    Function& function,
    std::size_t index,
    const std::vector<double>& parameters,
    const std::vector<std::string>& passes,
    SimplerFunctions& simpler) {
  RobotFunction& traced = function.traced;
  const bool has_formulation = !simpler.plain_programs.empty();
  function.results = std::make_shared<const AccurateResults>(
      has_formulation ? simpler.plain_programs[index] : traced.program, parameters);
  symbolic::Program searched = traced.program;
  traced = optimised(std::move(traced), passes);
  if (measure(traced, *function.results)) {
    if (function.congruent) function.congruent = pass::run(std::move(*function.congruent), passes);
    return;
  }
  function.congruent.reset();
  // Sums in another order have other rounding errors.
  RobotFunction as_traced = traced;
  as_traced.program = pass::run(std::move(searched), without(passes, "reassociate"));
  const bool keeps_digits = measure(as_traced, *function.results);
  traced = optimised(simpler.unsearched(index), passes);
  const bool is_unsearched_kept = measure(traced, *function.results);
  if (keeps_digits && (!is_unsearched_kept || symbolic::work(as_traced.program) < symbolic::work(traced.program))) {
    traced = std::move(as_traced);
    return;
  }
  if (is_unsearched_kept) return;
  traced = optimised(simpler.plain(index), passes);
  if (measure(traced, *function.results)) return;
  traced = simpler.plain(index);
  measure(traced, *function.results);
}

}  // namespace

Functions run_accurate_passes(
    const Robot& robot,
    Functions traced,
    const Formulation& formulation,
    const std::vector<std::string>& passes) {
  std::vector<std::string> groups;
  std::map<std::string, std::vector<std::size_t>> places;  // by group: the indices of its functions in the list
  for (std::size_t i = 0; i < traced.list.size(); ++i) {
    std::vector<std::size_t>& of_group = places[traced.list[i].traced.group];
    if (of_group.empty()) groups.push_back(traced.list[i].traced.group);
    of_group.push_back(i);
  }
  std::vector<std::unique_ptr<SimplerFunctions>> simpler(groups.size());
  for_each_index(groups.size(), [&](std::size_t g) {
    simpler[g] = std::make_unique<SimplerFunctions>(robot, groups[g], formulation);
  });
  struct Task {
    Function* function;
    std::size_t index;
    SimplerFunctions* simpler;
  };
  std::vector<Task> tasks;
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t i = 0; i < places[groups[g]].size(); ++i)
      tasks.push_back({&traced.list[places[groups[g]][i]], i, simpler[g].get()});
  const std::vector<double> parameters = algorithm::parameter_values(robot.tree);
  for_each_index(tasks.size(), [&](std::size_t k) {
    run_on(*tasks[k].function, tasks[k].index, parameters, passes, *tasks[k].simpler);
  });
  return traced;
}

}  // namespace robcogen::driver
