// Symbolic vectors and matrices with known numeric values, for comparison with Eigen.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <string>
#include <vector>

#include "algorithm/spatial/pose.h"
#include "symbolic/cost.h"
#include "symbolic/interpret.h"

namespace robcogen::algorithm::test {

// Products of a few numbers of order 1, with at most about a hundred rounding errors.
inline constexpr double kTolerance = 1e-13;

inline std::vector<Expression> flat(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

inline std::vector<Expression> flat(const Matrix3& m) {
  std::vector<Expression> all;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t r = 0; r < 3; ++r) all.push_back(m[r][c]);
  return all;
}

// A program with inputs `in` whose output `out` consists of these expressions.
inline symbolic::Program program(const Graph& graph, std::size_t inputs, const std::vector<Expression>& values) {
  return graph.program(
      "test", {{"in", symbolic::Role::value, std::vector<std::string>(inputs, "x")}},
      {{"out", symbolic::Role::value, static_cast<int>(values.size()), 1, {}}}, {values});
}

inline std::vector<double> evaluate(
    const Graph& graph,
    const std::vector<double>& inputs,
    const std::vector<Expression>& values) {
  return symbolic::interpret<double>(program(graph, inputs.size(), values), {{"in", inputs}}).at("out");
}

// A trace whose inputs are random numbers.
class Numbers {
 public:
  explicit Numbers(unsigned seed = 1) : random_(seed) {}

  model::KinematicTree no_robot;
  Trace trace{no_robot};
  Graph& graph = trace.graph;
  std::vector<double> inputs;

  double real() { return std::uniform_real_distribution<double>(-2, 2)(random_); }
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  Expression expression(double value) {
    inputs.push_back(value);
    return graph.input(static_cast<int>(inputs.size()) - 1);
  }
  Vector3 vector() { return {expression(real()), expression(real()), expression(real())}; }
  Matrix3 matrix() { return {{vector(), vector(), vector()}}; }
  Matrix3 symmetric() {
    Matrix3 m = matrix();
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < r; ++c) m[r][c] = m[c][r];
    return m;
  }

  double value(const Expression& e) const { return evaluate(graph, inputs, {e}).front(); }
  Eigen::Vector3d value(const Vector3& v) const { return Eigen::Vector3d(evaluate(graph, inputs, flat(v)).data()); }
  Eigen::Matrix3d value(const Matrix3& m) const { return Eigen::Matrix3d(evaluate(graph, inputs, flat(m)).data()); }

  symbolic::Cost count(const std::vector<Expression>& values) const {
    return symbolic::cost(program(graph, inputs.size(), values));
  }

 private:
  std::mt19937 random_;
};

inline Eigen::Matrix3d turn(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
}

}  // namespace robcogen::algorithm::test
