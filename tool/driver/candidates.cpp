#include "driver/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "pass/passes.h"
#include "support/parallel.h"
#include "symbolic/cost.h"

namespace robcogen::driver {
namespace {

using algorithm::Search;
using symbolic::AccurateResults;

const char* name_of(Formulated formulated) {
  switch (formulated) {
    case Formulated::searched:
      return "searched";
    case Formulated::unsearched:
      return "unsearched";
    case Formulated::plainly:
      return "plainly";
    case Formulated::reference:
      return "reference";
    case Formulated::for_lanes:
      return "for_lanes";
    case Formulated::unsearched_for_lanes:
      break;
  }
  return "unsearched_for_lanes";
}

Passes without(Passes passes, const std::string& name) {
  std::erase(passes, name);
  return passes;
}

void choose_candidate(
    Function& function,
    const std::vector<double>& parameters,
    Formulations& formulations,
    const Passes& passes) {
  symbolic::Function first = traced(function, formulations.of(Formulated::searched));
  if (!function.results)
    function.results = std::make_shared<const AccurateResults>(
        has_formulation(function) ? traced(function, formulations.of(Formulated::reference)).program : first.program,
        parameters);
  bool is_first = true;
  Candidate chosen = choose(recipes(passes), *function.results, [&](const Recipe& recipe) {
    symbolic::Function made = is_first ? std::move(first) : traced(function, formulations.of(recipe.formulated));
    is_first = false;
    made.program = pass::run(std::move(made.program), recipe.passes);
    return made;
  });
  function.is_first_choice = chosen.recipe == Recipe{Formulated::searched, passes};
  static_cast<symbolic::Function&>(function) = std::move(chosen.function);
}

bool is_fused(const Function& function) {
  return !function.declared->parts.empty();
}

// The search on which a function's frames depend; those of a fused function depend on its parts.
Search search_of(const Function& function) {
  return function.declared->is->program.search;
}

// The functions for which an effort is chosen: the first one with each search, and each fused one.
std::vector<std::size_t> first_of_searches(const std::vector<Function>& functions) {
  std::vector<std::size_t> result;
  std::set<Search> known;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const Function& function = functions[i];
    if (!has_formulation(function)) continue;
    if (is_fused(function) || known.insert(search_of(function)).second) result.push_back(i);
  }
  return result;
}

}  // namespace

std::string print(const Recipe& recipe) {
  return fmt::format("{}: {}", name_of(recipe.formulated), fmt::join(recipe.passes, ", "));
}

std::vector<std::vector<Recipe>> recipes(const Passes& passes) {
  return {
      {{Formulated::searched, passes}},
      // Sums in another order have other rounding errors.
      {{Formulated::unsearched, passes}, {Formulated::searched, without(passes, "reassociate")}},
      {{Formulated::plainly, passes}},
      {{Formulated::plainly, {}}}};
}

Candidate choose(
    const std::vector<std::vector<Recipe>>& recipes,
    const AccurateResults& results,
    const std::function<symbolic::Function(const Recipe&)>& make) {
  Candidate last;
  for (const std::vector<Recipe>& recipes_of_a_kind : recipes) {
    std::vector<Candidate> candidates;
    for (const Recipe& recipe : recipes_of_a_kind) candidates.push_back({recipe, make(recipe)});
    if (candidates.size() > 1)
      std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return symbolic::work(a.function.program) < symbolic::work(b.function.program);
      });
    for (Candidate& candidate : candidates) {
      const symbolic::Accuracy accuracy = results.accuracy_of(candidate.function.program);
      candidate.function.error = accuracy.error;
      last = std::move(candidate);
      if (accuracy.is_kept) return last;
    }
  }
  return last;
}

Functions choose_candidates(
    const Robot& robot,
    Functions functions,
    FormulationsByEffort& formulations,
    const Passes& passes,
    const CostOfPrinted& cost) {
  std::vector<Function>& list = functions.list;
  const std::vector<double> parameters = algorithm::parameter_values(robot.tree);
  const auto choose_with = [&](int effort, Function& function) {
    function.effort = effort;
    choose_candidate(function, parameters, formulations.with(effort), passes);
  };
  const auto choose_among = [&](const std::vector<int>& efforts, Function& function) {
    if (efforts.size() == 1) return choose_with(efforts.front(), function);
    const Function declared = function;
    choose_with(efforts.front(), function);
    int least = cost(function);
    for (auto effort = efforts.begin() + 1; effort != efforts.end(); ++effort) {
      Function other = declared;
      other.results = function.results;
      choose_with(*effort, other);
      const int of_other = cost(other);
      if (of_other < least) function = std::move(other), least = of_other;
    }
  };
  const int most = formulations.efforts().front();
  std::vector<std::vector<int>> efforts(list.size(), {most});
  if (cost) {
    const std::vector<std::size_t> firsts = first_of_searches(list);
    for_each_index(firsts.size(), [&](std::size_t k) { choose_among(formulations.efforts(), list[firsts[k]]); });
    std::map<Search, int> best;
    for (const std::size_t i : firsts) {
      efforts[i].clear();
      if (!is_fused(list[i])) best[search_of(list[i])] = list[i].effort;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto found = best.find(search_of(list[i]));
      if (!efforts[i].empty() && found != best.end() && found->second != most) efforts[i].push_back(found->second);
    }
  }
  for_each_index(list.size(), [&](std::size_t i) {
    if (!efforts[i].empty()) choose_among(efforts[i], list[i]);
  });
  return functions;
}

}  // namespace robcogen::driver
