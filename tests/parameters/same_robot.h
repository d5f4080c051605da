// Comparisons of a robot with parameters with the constant robot of the same values.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "robcogen/reference/check_parameters.h"
#include "values.h"

namespace robcogen::test {

using reference::CompiledRobot;
using reference::Sample;
using Values = std::vector<double>;

// Constants fold exactly, and sums are added in another order: rounding of both programs, relative to the largest
// element.
inline constexpr double kSame = 1e-12;
// Rounding of joint forces, propagated to accelerations by the inverse of H.
inline constexpr double kSameAcceleration = 1e-11;

inline void append(Values& to, const reference::Matrix<double>& m) {
  to.insert(to.end(), m.data(), m.data() + m.rows() * m.cols());
}

struct Result {
  std::string name;
  Values values;
  double tolerance = kSame;
};

// Everything that the functions return in one state, with and without gravity and wrenches as arguments.
template <class R>
std::vector<Result> results(const CompiledRobot<R>& robot, const reflection::Robot& tables, const Sample& s) {
  std::vector<Result> all;
  const auto add = [&](const std::string& name, const auto& value, double tolerance = kSame) {
    append(all.emplace_back(Result{name, {}, tolerance}).values, value);
  };
  const reference::Arguments given{&s.gravity, &s.external}, gravity{&s.gravity, nullptr}, none{};
  for (const auto& [suffix, arguments] : {std::pair("", none), {" (gravity)", gravity}, {" (all)", given}}) {
    const std::string end = suffix;
    add("inverse_dynamics" + end, robot.inverse_dynamics(s.motion, arguments));
    add("inverse_dynamics_fully_actuated" + end, robot.inverse_dynamics_fully_actuated(s.motion, arguments));
    add("forward_dynamics" + end, robot.forward_dynamics(s.motion, s.motion.qdd, arguments), kSameAcceleration);
    add("bias_forces" + end, robot.bias_forces(s.motion, arguments));
    if (arguments.external != nullptr) continue;
    add("gravity_forces" + end, robot.gravity_forces(s.motion.q, arguments));
    all.push_back({"potential_energy" + end, {robot.potential_energy(s.motion.q, arguments)}});
  }
  add("coriolis_forces", robot.coriolis_forces(s.motion));
  add("joint_space_inertia", robot.joint_space_inertia(s.motion.q));
  add("coriolis_matrix", robot.coriolis_matrix(s.motion));
  add("center_of_mass", robot.center_of_mass(s.motion.q));
  add("center_of_mass_jacobian", robot.center_of_mass_jacobian(s.motion.q));
  add("centroidal_momentum_matrix", robot.centroidal_momentum_matrix(s.motion.q));
  all.push_back({"kinetic_energy", {robot.kinetic_energy(s.motion)}});
  for (int i = 0; i < tables.transforms.size; ++i) {
    const reference::TransformForms X = robot.transform(i, s.motion.q);
    add(std::string("homogeneous ") + tables.transforms[i].name, X.homogeneous);
    add(std::string("motion ") + tables.transforms[i].name, X.motion);
    add(std::string("force ") + tables.transforms[i].name, X.force);
  }
  for (int i = 0; i < tables.jacobians.size; ++i) add(tables.jacobians[i].name, robot.jacobian(i, s.motion.q));
  return all;
}

// Compares both robots in several states.
template <class Parametric, class Constant>
void expect_same(
    const Parametric& parametric,
    const reflection::Robot& parametric_tables,
    const reflection::Robot& constant_tables) {
  const CompiledRobot<Parametric> a(parametric_tables, parametric);
  const CompiledRobot<Constant> b(constant_tables);
  std::mt19937_64 engine(5);
  for (int i = 0; i < 20; ++i) {
    const Sample s = reference::random_sample(engine, constant_tables);
    const std::vector<Result> found = results(a, parametric_tables, s), expected = results(b, constant_tables, s);
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_GT(constant_tables.transforms.size, 0);
    ASSERT_GT(constant_tables.jacobians.size, 0);
    for (std::size_t k = 0; k < found.size(); ++k) {
      ASSERT_EQ(found[k].name, expected[k].name);
      ASSERT_EQ(found[k].values.size(), expected[k].values.size()) << found[k].name;
      double scale = 0;
      for (const double x : expected[k].values) scale = std::max(scale, std::abs(x));
      for (std::size_t e = 0; e < found[k].values.size(); ++e)
        EXPECT_NEAR(found[k].values[e], expected[k].values[e], found[k].tolerance * scale)
            << found[k].name << " " << e << ", sample " << i;
    }
  }
}

// The numbers from which the checks of this robot compute are those of the constant robots.
inline void expect_numbers(
    const reflection::Robot& parametric,
    const std::vector<double>& values,
    const reflection::Robot& constant) {
  const reference::RobotOf made(parametric, values);
  const auto near = [](const double* a, const double* b, int n) {
    for (int i = 0; i < n; ++i) EXPECT_NEAR(a[i], b[i], 1e-15);  // a few roundings of numbers below 1
  };
  for (int i = 0; i < constant.links.size; ++i) {
    const reflection::Link &a = made.robot().links[i], &b = constant.links[i];
    EXPECT_NEAR(a.mass, b.mass, 1e-14);
    near(a.com, b.com, 3);
    near(a.inertia, b.inertia, 6);
  }
  for (int i = 0; i < constant.joints.size; ++i) {
    near(made.robot().joints[i].translation, constant.joints[i].translation, 3);
    near(made.robot().joints[i].rotation, constant.joints[i].rotation, 3);
  }
  for (int i = 0; i < constant.frames.size; ++i) {
    near(made.robot().frames[i].translation, constant.frames[i].translation, 3);
    near(made.robot().frames[i].rotation, constant.frames[i].rotation, 3);
  }
}

// The elements of a parameter set as the checks take them.
template <class ParameterSet>
std::vector<double> numbers_of(const ParameterSet& parameters) {
  const auto array = parameters.array();
  return {array.begin(), array.end()};
}

}  // namespace robcogen::test
