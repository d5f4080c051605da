// The functions of a model on their way from declarations to a library, as each phase hands them to the next.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "backend/library.h"
#include "driver/load.h"
#include "symbolic/accuracy.h"

namespace robcogen::driver {

// What is printed, once it is chosen; before that, its names.
struct Function : symbolic::Function {
  // Of a robot: what it is, and the derivatives that the user asks for, each of the function before it.
  std::shared_ptr<const algorithm::Declared> declared = {};
  std::vector<Derivative> derivatives_in_turn = {};

  // The results against which rounding errors are measured, if they are.
  std::shared_ptr<const symbolic::AccurateResults> results = {};
  // Of a robot: the effort of the search for its link frames.
  int effort = 0;
  // Of a robot: the first candidate was chosen.
  bool is_first_choice = false;
  bool is_stage = false;  // computes the right-hand sides of another function
  // Set for languages with vectors: why no limbs share lanes, where two congruent limbs or more take part.
  std::string without_lanes = {};
};

struct Functions {
  std::vector<Function> list;
  // The same as the members of these names in backend::Library.
  std::vector<symbolic::Function> updates = {}, numbers = {};
  std::optional<backend::Library::Trigonometry> trigonometry = {};
};

}  // namespace robcogen::driver
