// The functions of a model on their way from the algorithms to a library: what each phase hands to the next.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "backend/library.h"
#include "symbolic/accuracy.h"

namespace robcogen::driver {

struct Function {
  algorithm::RobotFunction traced;  // name, documentation, program
  int transform = -1;               // of a document without robot: which of its transforms it is

  // The same program with congruent limbs that fold in the same way, where that is another one.
  std::optional<symbolic::Program> congruent = {};
  // The results that its rounding errors are measured against, where they are.
  std::shared_ptr<const symbolic::AccurateResults> results = {};
  // The same program with congruent limbs in lanes, if there is one; and the limbs, a text for each class.
  std::optional<symbolic::Program> in_lanes = {};
  std::vector<std::string> limbs_in_lanes = {};
  std::optional<symbolic::AngleParts> parts = {};
  bool is_stage = false;  // of another function: its right-hand sides
};

struct Functions {
  std::vector<Function> list;
  // See the members of the same names of backend::Library.
  std::vector<backend::Function> updates = {}, numbers = {};
  std::optional<backend::Library::Trigonometry> trigonometry = {};
};

}  // namespace robcogen::driver
