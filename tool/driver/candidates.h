// The ways to compute a function of a robot, and the choice among them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "driver/formulations.h"

namespace robcogen::driver {

using Passes = std::vector<std::string>;

// A candidate before it is traced: the formulation, and the passes that run on the program.
struct Recipe {
  Formulated formulated = Formulated::searched;
  Passes passes = {};
  friend bool operator==(const Recipe&, const Recipe&) = default;
};

// `searched: fold, reassociate`
std::string print(const Recipe& recipe);

struct Candidate {
  Recipe recipe;
  symbolic::Function function;
};

// The recipes with these passes, by increasing cost. Which of several in one list is cheaper depends on the function.
// The last one computes the textbook algorithm as it is.
std::vector<std::vector<Recipe>> recipes(const Passes& passes);

// The first candidate, by increasing cost, that keeps the digits of the plain formulation; if none does, the last one.
// Its rounding error is set.
Candidate choose(
    const std::vector<std::vector<Recipe>>& recipes,
    const symbolic::AccurateResults& results,
    const std::function<symbolic::Function(const Recipe&)>& make);

// The cost of a function as it will be printed. It may complete the function for that.
using CostOfPrinted = std::function<int(Function&)>;

// Chooses among the candidates of each function of a robot, and the effort of its search for link frames. The first
// function with each search takes the effort with which it costs least, of equal ones the most; where that is less than
// the effort of the steps, the others are compared with both. Without `cost` all take the effort of the steps.
Functions choose_candidates(
    const Robot& robot,
    Functions functions,
    FormulationsByEffort& formulations,
    const Passes& passes,
    const CostOfPrinted& cost);

}  // namespace robcogen::driver
