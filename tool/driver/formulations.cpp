#include "driver/formulations.h"

#include <utility>

#include "driver/derivatives.h"
#include "driver/fused_functions.h"

namespace robcogen::driver {

using algorithm::Formulation;
using algorithm::FormulationChoices;

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

FormulationsByEffort::FormulationsByEffort(const Robot& robot, const Formulation& of_steps) {
  for (Formulation formulation = of_steps;; formulation.effort /= 2) {
    efforts_.push_back(formulation.effort);
    formulations_[formulation.effort] = std::make_unique<Formulations>(robot, formulation);
    if (formulation.effort <= 0) break;
  }
}

bool has_formulation(const Function& function) {
  return !function.derivatives_in_turn.empty() || algorithm::is_formulated(*function.declared);
}

symbolic::Function traced(const Function& function, FormulationChoices& choices) {
  symbolic::Function result = algorithm::trace(*function.declared, choices);
  if (!result.parts.empty()) require_compilable(result);
  for (const Derivative& derivative : function.derivatives_in_turn)
    result = differentiated(std::move(result), derivative, *function.declared, choices);
  return result;
}

}  // namespace robcogen::driver
