// The functions of a model on their way from the algorithms to a library, as each phase hands them to the next.
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
  int transform = -1;               // without a robot: index of the transform in the document

  // The same program in the formulation in which congruent limbs fold in the same way, if that is a different program.
  std::optional<symbolic::Program> congruent = {};
  // The results against which its rounding errors are measured, if they are.
  std::shared_ptr<const symbolic::AccurateResults> results = {};
  // The same program with congruent limbs in lanes, if there is one, and a text for each class of congruent limbs.
  std::optional<symbolic::Program> in_lanes = {};
  std::vector<std::string> limbs_in_lanes = {};
  std::optional<symbolic::AngleParts> parts = {};
  bool is_stage = false;  // computes the right-hand sides of another function
};

struct Functions {
  std::vector<Function> list;
  // The same as the members of these names in backend::Library.
  std::vector<backend::Function> updates = {}, numbers = {};
  std::optional<backend::Library::Trigonometry> trigonometry = {};
};

}  // namespace robcogen::driver
