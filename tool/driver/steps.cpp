#include "driver/steps.h"

#include <algorithm>

#include "pass/passes.h"

namespace robcogen::driver {

std::vector<std::string> all_steps() {
  std::vector<std::string> all = algorithm::choices();
  all.insert(all.end(), pass::names().begin(), pass::names().end());
  all.emplace_back(kLanesStep);
  return all;
}

algorithm::Formulation Steps::formulation() const {
  std::vector<std::string> taken = names;
  algorithm::Formulation result = algorithm::take_formulation(taken);
  result.effort = effort;
  return result;
}

std::vector<std::string> Steps::passes() const {
  std::vector<std::string> taken = names;
  algorithm::take_formulation(taken);
  std::erase(taken, kLanesStep);
  return taken;
}

bool Steps::has_lanes() const {
  return std::count(names.begin(), names.end(), kLanesStep) > 0;
}

}  // namespace robcogen::driver
