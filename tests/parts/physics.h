// Random robots as parts of others, and their dynamics and kinematics in the interpreter.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "coupled_robot.h"
#include "dice.h"
#include "export/kinematics.h"
#include "import/kinematics.h"
#include "import/parts.h"
#include "random_drives.h"
#include "random_robot.h"
#include "robcogen/reference/matrix.h"
#include "symbolic/interpret.h"

namespace robcogen::test {

namespace kinematics = language::kinematics;
using Vector = reference::Vector<double>;
using Matrix = reference::Matrix<double>;

// A fixed or floating robot with a few joints, sometimes with drives, sometimes with coupled joints.
inline kinematics::Document random_document(std::uint64_t seed) {
  model::KinematicTree robot = numeric::random_robot(seed, {.min_joints = 1, .max_joints = 7});
  if (seed % 3 != 0) robot = numeric::with_random_drives(robot, seed);
  if (seed % 2 == 1) robot = numeric::coupled(robot, seed).robot;
  return exporting::kinematics_document(robot);
}

inline kinematics::Document parsed(const std::string& text) {
  Diagnostics diagnostics;
  kinematics::Document document = kinematics::parse(std::make_shared<Source>("robot.kindsl", text), diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render() << text;
  return document;
}

// Expands the parts of a document; every import yields `imported`.
inline kinematics::Document expanded(kinematics::Document document, const kinematics::Document& imported = {}) {
  Diagnostics diagnostics;
  const auto part = std::make_shared<const kinematics::Document>(imported);
  auto result = import::expand(
      std::make_shared<const kinematics::Document>(std::move(document)), [&](const auto&, const auto&) { return part; },
      diagnostics);
  EXPECT_TRUE(result.has_value()) << diagnostics.render();
  return result.value_or(kinematics::Document());
}

inline model::KinematicTree tree_of(const kinematics::Document& document) {
  Diagnostics diagnostics;
  auto tree = import::kinematic_tree(document, diagnostics);
  EXPECT_TRUE(tree.has_value()) << diagnostics.render() << kinematics::print(document);
  return tree.value_or(model::KinematicTree());
}

struct State {
  Vector q, qd, base_velocity, gravity;
};

inline Vector random_vector(numeric::Dice& dice, int size) {
  Vector v(size);
  for (int i = 0; i < size; ++i) v(i) = dice.between(-1.0, 1.0);
  return v;
}

// Returns the result for the base first, then that for the joints.
inline std::vector<double> result(const symbolic::Program& program, const State& s) {
  symbolic::Arrays<double> inputs = {
      {"q", s.q.values()},
      {"qd", s.qd.values()},
      {"base_velocity", s.base_velocity.values()},
      {"gravity", s.gravity.values()}};
  std::erase_if(inputs, [&](const auto& given) {
    return std::none_of(program.inputs.begin(), program.inputs.end(), [&](const symbolic::InputArray& array) {
      return array.name == given.first;
    });
  });
  const symbolic::Arrays<double> results = symbolic::interpret(program, inputs);
  if (program.outputs.size() == 1) return results.at(program.outputs.front().name);
  std::vector<double> all = results.at("base_wrench");
  const std::vector<double>& tau = results.at("tau");
  all.insert(all.end(), tau.begin(), tau.end());
  return all;
}

inline Matrix matrix(const std::vector<double>& values, int rows) {
  Matrix m(rows, rows == 0 ? 0 : static_cast<int>(values.size()) / rows);
  std::copy(values.begin(), values.end(), m.data());
  return m;
}

// Returns a function of the robot by its name.
inline symbolic::Program program_of(
    const model::KinematicTree& tree,
    const std::string& group,
    const std::string& name) {
  for (symbolic::Function& f : algorithm::functions(tree, {}, group))
    if (f.program.name == name) return std::move(f.program);
  ADD_FAILURE() << name;
  return {};
}

inline Matrix inertia_matrix(const model::KinematicTree& tree, const State& s) {
  return matrix(
      result(program_of(tree, "joint_space_inertia", "joint_space_inertia"), s),
      tree.dof() + (tree.floating_base ? 6 : 0));
}

inline Vector bias_forces(const model::KinematicTree& tree, const State& s) {
  const std::string name = tree.floating_base ? "bias_forces" : "bias_forces_gravity";
  return matrix(result(program_of(tree, "bias_forces", name), s), tree.dof() + (tree.floating_base ? 6 : 0));
}

inline double size(const Matrix& m) {
  double most = 0;
  for (const double x : m.values()) most = std::max(most, std::abs(x));
  return most;
}

inline void expect_equal(const Matrix& a, const Matrix& b, const std::string& what) {
  constexpr double kTolerance = 1e-12;
  ASSERT_EQ(a.rows(), b.rows()) << what;
  ASSERT_EQ(a.cols(), b.cols()) << what;
  Matrix difference = a;
  for (int i = 0; i < a.rows(); ++i)
    for (int k = 0; k < a.cols(); ++k) difference(i, k) -= b(i, k);
  EXPECT_LE(size(difference), kTolerance * std::max(1.0, size(b))) << what;
}

}  // namespace robcogen::test
