// Choices between forms of the same dynamics. Any of them can be switched off: results differ by rounding only.
#pragma once

#include <string>
#include <vector>

namespace robcogen::algorithm {

struct Formulation {
  bool regroup = true;                  // mass properties that a joint does not feel move to the parent (regroup.h)
  bool choose_forward_dynamics = true;  // by inertia matrix where that is quicker; else always by articulated bodies
};

// Names of the choices, in the order of the fields.
const std::vector<std::string>& choices();

// Takes the choices out of a list of names: those found are on, the others off. What is left is not looked at.
Formulation take_formulation(std::vector<std::string>& names);

}  // namespace robcogen::algorithm
