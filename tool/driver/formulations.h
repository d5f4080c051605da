// The formulations in which a robot's functions are traced.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "driver/functions.h"
#include "support/lazy.h"

namespace robcogen::driver {

// The formulation in which a function is traced.
enum class Formulated {
  searched,    // with the choices of the steps, in searched link frames
  unsearched,  // with the same choices, in the frames of the model
  plainly,     // the textbook algorithm
  reference,   // the same without names, for results to compare with
  for_lanes,   // as searched, but congruent limbs fold in the same way
  unsearched_for_lanes,
};

// The choices of each formulation of a robot with one effort of the search, made when they are first needed.
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

// A search with more effort finds frames that cost less by its own measure. The program that is printed may cost more,
// because passes and lanes change it, or because it loses digits. So less effort is tried, too.
class FormulationsByEffort {
 public:
  FormulationsByEffort(const Robot& robot, const algorithm::Formulation& of_steps);

  // The effort of the steps, its half and so on down to one, and none.
  const std::vector<int>& efforts() const { return efforts_; }
  Formulations& with(int effort) { return *formulations_.at(effort); }

 private:
  std::vector<int> efforts_;
  std::map<int, std::unique_ptr<Formulations>> formulations_;
};

// Whether a function's program depends on the formulation.
bool has_formulation(const Function& function);

// The function as one formulation traces it.
symbolic::Function traced(const Function& function, algorithm::FormulationChoices& choices);

}  // namespace robcogen::driver
