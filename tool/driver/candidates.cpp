#include "driver/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "driver/derivatives.h"
#include "driver/fused_functions.h"
#include "pass/passes.h"
#include "support/parallel.h"
#include "symbolic/cost.h"

namespace robcogen::driver {
namespace {

using algorithm::Formulation;
using algorithm::FormulationChoices;
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

}  // namespace

bool has_formulation(const Function& function) {
  return !function.derivatives_in_turn.empty() || algorithm::is_formulated(*function.declared);
}

std::string print(const Recipe& recipe) {
  return fmt::format("{}: {}", name_of(recipe.formulated), fmt::join(recipe.passes, ", "));
}

Formulations::Formulations(const Robot& robot, const Formulation& of_steps)
    : robot_(robot), of_steps_(of_steps), searched_(robot.tree, of_steps) {}

FormulationChoices& Formulations::of(Formulated formulated) {
  const auto with = [&](Formulation formulation, auto change) {
    change(formulation);
    return std::make_unique<FormulationChoices>(robot_.tree, formulation);
  };
  const auto for_congruent_limbs = [](FormulationChoices& original) {
    return std::unique_ptr<FormulationChoices>(
        new FormulationChoices(FormulationChoices::for_congruent_limbs(original)));
  };
  switch (formulated) {
    case Formulated::searched:
      break;
    case Formulated::unsearched:
      return *unsearched_.get([&] { return with(of_steps_, [](Formulation& f) { f.effort = 0; }); });
    case Formulated::plainly:
      return *plainly_.get([&] { return with(algorithm::plain_formulation(), [](Formulation&) {}); });
    case Formulated::reference:
      return *reference_.get(
          [&] { return with(algorithm::plain_formulation(), [](Formulation& f) { f.is_draft = true; }); });
    case Formulated::for_lanes:
      return *for_lanes_.get([&] { return for_congruent_limbs(searched_); });
    case Formulated::unsearched_for_lanes:
      return *unsearched_for_lanes_.get([&] { return for_congruent_limbs(of(Formulated::unsearched)); });
  }
  return searched_;
}

symbolic::Function traced(const Function& function, FormulationChoices& choices) {
  symbolic::Function result = algorithm::trace(*function.declared, choices);
  if (!result.parts.empty()) require_compilable(result);
  for (const Derivative* derivative : function.derivatives_in_turn)
    result = differentiated(std::move(result), *derivative, *function.declared, choices);
  return result;
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

Functions choose_candidates(const Robot& robot, Functions functions, Formulations& formulations, const Passes& passes) {
  const std::vector<double> parameters = algorithm::parameter_values(robot.tree);
  for_each_index(functions.list.size(), [&](std::size_t i) {
    choose_candidate(functions.list[i], parameters, formulations, passes);
  });
  return functions;
}

}  // namespace robcogen::driver
