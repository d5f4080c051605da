#include "algorithm/formulation/formulation.h"

#include <array>

namespace robcogen::algorithm {
namespace {

struct Choice {
  const char* name;
  bool Formulation::*on;
};

constexpr std::array kChoices = {
    Choice{"base-parameters", &Formulation::base_parameters},
    Choice{"choose-fd", &Formulation::choose_forward_dynamics}, Choice{"frames", &Formulation::choose_frames},
    Choice{"turn-inertia", &Formulation::turn_inertia}, Choice{"reverse-mode", &Formulation::choose_reverse_mode}};

}  // namespace

Formulation plain_formulation() {
  std::vector<std::string> none;
  return take_formulation(none);
}

symbolic::DerivativeMode derivative_mode(const Formulation& formulation) {
  return formulation.choose_reverse_mode ? symbolic::DerivativeMode::cheaper : symbolic::DerivativeMode::forward;
}

const std::vector<std::string>& choices() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> list;
    for (const Choice& choice : kChoices) list.emplace_back(choice.name);
    return list;
  }();
  return all;
}

Formulation take_formulation(std::vector<std::string>& names) {
  Formulation result;
  for (const Choice& choice : kChoices) result.*choice.on = std::erase(names, choice.name) > 0;
  return result;
}

}  // namespace robcogen::algorithm
