// The ways to compute a function of a robot, and the choice among them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "driver/functions.h"
#include "support/lazy.h"

namespace robcogen::driver {

using Passes = std::vector<std::string>;

// The formulation in which a function is traced.
enum class Formulated {
  searched,    // with the choices of the steps, in searched link frames
  unsearched,  // with the same choices, in the frames of the model
  plainly,     // the textbook algorithm
  reference,   // the same without names, for results to compare with
  for_lanes,   // as searched, but congruent limbs fold in the same way
  unsearched_for_lanes,
};

// A candidate before it is traced: the formulation, and the passes that run on the program.
struct Recipe {
  Formulated formulated = Formulated::searched;
  Passes passes = {};
  friend bool operator==(const Recipe&, const Recipe&) = default;
};

// `searched: fold, reassociate`
std::string print(const Recipe& recipe);

// The choices of each formulation of a robot, made when they are first needed.
class Formulations {
 public:
  Formulations(const Robot& robot, const algorithm::Formulation& of_steps);

  algorithm::FormulationChoices& of(Formulated formulated);
  // Whether link frames are searched for, so that searched and unsearched formulations may differ.
  bool are_searched() const { return of_steps_.effort > 0; }

 private:
  const Robot& robot_;
  algorithm::Formulation of_steps_;
  algorithm::FormulationChoices searched_;
  Lazy<std::unique_ptr<algorithm::FormulationChoices>> unsearched_, plainly_, reference_, for_lanes_,
      unsearched_for_lanes_;
};

// Whether a function's program depends on the formulation.
bool has_formulation(const Function& function);

// The function as one formulation traces it.
symbolic::Function traced(const Function& function, algorithm::FormulationChoices& choices);

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

// Chooses among the candidates of each function of a robot.
Functions choose_candidates(const Robot& robot, Functions functions, Formulations& formulations, const Passes& passes);

}  // namespace robcogen::driver
