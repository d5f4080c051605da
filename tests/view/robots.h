// Robots to draw.
#pragma once

#include <cmath>
#include <filesystem>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "driver/driver.h"
#include "model/elements.h"
#include "view/robot.h"

namespace robcogen::test {

inline const std::string kRobots[] = {"hyl",       "hyl_parametric",  "tree5", "scara",    "gripper",  "iiwa14",
                                      "quadruped", "quadruped_fixed", "wrist", "ball_leg", "five_bar", "humanoid"};

inline driver::Model load_robot(const std::string& name) {
  Diagnostics diagnostics;
  const auto file = std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / name / (name + ".kindsl");
  const std::optional<driver::Model> model = driver::load(file, {}, diagnostics);
  if (!model) throw std::runtime_error(diagnostics.render());
  return *model;
}

// Positions that differ from joint to joint.
inline std::vector<double> some_positions(const view::ViewedRobot& robot) {
  std::vector<double> q;
  const model::KinematicTree& tree = robot.library.tree;
  for (int k = 0; k < tree.position_count(); ++k) q.push_back(0.3 + 0.17 * (k % 7));
  for (const int first : model::quaternions(tree)) {
    const auto begin = q.begin() + first;
    const double norm = std::sqrt(std::inner_product(begin, begin + 4, begin, 0.0));
    for (auto e = begin; e < begin + 4; ++e) *e /= norm;
  }
  return q;
}

inline std::vector<double> declared_parameters(const view::ViewedRobot& robot) {
  std::vector<double> values;
  for (const model::Parameter& p : robot.library.tree.parameters) values.push_back(p.default_value.value_or(0.7));
  return values;
}

}  // namespace robcogen::test
