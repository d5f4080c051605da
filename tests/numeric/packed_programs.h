// Programs of robots in lanes, and their comparison with the programs without lanes.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "algorithm/formulation/congruent_limbs.h"
#include "import/kinematics.h"
#include "import/parts.h"
#include "pass/lanes/correspondence.h"
#include "symbolic/interpret.h"

namespace robcogen::numeric {

// Relative to the largest value of the array: both programs are interpreted in double, and round in a different order.
inline constexpr double kLanesTolerance = 1e-11;

inline model::KinematicTree document_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const auto source = std::make_shared<Source>(file, std::string(std::istreambuf_iterator<char>(stream), {}));
  Diagnostics diagnostics;
  const auto read = import::robot_document(source, {}, diagnostics);
  const auto tree = read ? import::kinematic_tree(read->document, diagnostics) : std::nullopt;
  EXPECT_TRUE(tree.has_value()) << file;
  return *tree;
}

inline model::KinematicTree document(const std::string& name) {
  return document_of(std::string(ROBCOGEN_ROBOTS_DIR) + "/" + name + "/" + name + ".kindsl");
}

inline std::vector<pass::InputTuples> classes_of(const model::KinematicTree& tree, const symbolic::Program& program) {
  std::vector<pass::InputTuples> classes;
  for (const algorithm::LimbsInLanes& limbs : algorithm::limbs_in_lanes(tree))
    classes.push_back(algorithm::limb_inputs(tree, limbs, program));
  return classes;
}

inline symbolic::Arrays<double> random_inputs(const symbolic::Program& program, std::uint64_t seed) {
  std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
  symbolic::Arrays<double> inputs;
  for (const symbolic::InputArray& array : program.inputs)
    for (std::size_t k = 0; k < array.elements.size(); ++k)
      inputs[array.name].push_back(std::uniform_real_distribution<double>(-2, 2)(random));
  return inputs;
}

// Returns a description of the first difference, or an empty string.
inline std::string difference(const symbolic::Program& expected, const symbolic::Program& program, std::uint64_t seed) {
  const symbolic::Arrays<double> inputs = random_inputs(expected, seed);
  const auto wanted = symbolic::interpret<double>(expected, inputs);
  const auto found = symbolic::interpret<double>(program, inputs);
  for (const auto& [name, values] : wanted) {
    double scale = 1;
    for (const double value : values) scale = std::max(scale, std::abs(value));
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!(std::abs(values[k] - found.at(name)[k]) <= kLanesTolerance * scale))
        return name + "[" + std::to_string(k) + "]: " + std::to_string(found.at(name)[k]) + " instead of " +
               std::to_string(values[k]);
  }
  return "";
}

}  // namespace robcogen::numeric
