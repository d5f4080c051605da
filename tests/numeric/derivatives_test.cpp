// Derivatives by recursion agree with those of single statements, exactly differentiated, on random robots.
#include <gtest/gtest.h>

#include "algorithm/dynamics/dynamics.h"
#include "dice.h"
#include "random_robot.h"
#include "symbolic/derivative.h"
#include "symbolic/interpret.h"

namespace robcogen::numeric {
namespace {

using algorithm::Loads;
using symbolic::Arrays;
using symbolic::Program;

constexpr int kRobots = 200;
constexpr double kNear = 1e-12;

Arrays<double> random_inputs(const Program& program, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  Arrays<double> inputs;
  for (const symbolic::InputArray& array : program.inputs)
    for (std::size_t k = 0; k < array.elements.size(); ++k)
      inputs[array.name].push_back(static_cast<double>(engine() >> 11) * 0x1p-51 - 2.0);
  return inputs;
}

double largest(const std::vector<double>& values) {
  double result = 1.0;
  for (const double x : values) result = std::max(result, std::abs(x));
  return result;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, const std::string& what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  const double near = kNear * largest(expected);
  for (std::size_t k = 0; k < found.size(); ++k) ASSERT_NEAR(found[k], expected[k], near) << what << ' ' << k;
}

// The rows of the base, then those of the joints.
std::vector<double> stacked(const Arrays<double>& results, const std::string& input, int rows_of_base, int rows) {
  const std::vector<double>& joints = results.at(rows_of_base > 0 ? "tau_d_" + input : "d_" + input);
  if (rows_of_base == 0) return joints;
  const std::vector<double>& base = results.at("base_wrench_d_" + input);
  std::vector<double> result;
  for (std::size_t c = 0; c < base.size() / 6; ++c) {
    const auto n = static_cast<std::ptrdiff_t>(rows), column = static_cast<std::ptrdiff_t>(c);
    result.insert(result.end(), base.begin() + 6 * column, base.begin() + 6 * (column + 1));
    result.insert(result.end(), joints.begin() + n * column, joints.begin() + n * (column + 1));
  }
  return result;
}

TEST(Derivatives, OfInverseDynamicsByBothWays) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = random_robot(seed, {.max_joints = 12});
    const Loads loads = seed % 2 == 0 ? Loads::gravity : Loads::gravity_and_external;
    const Program recursion = algorithm::inverse_dynamics_derivatives(robot, "f", loads);
    const Program plain = algorithm::newton_euler(robot, "f", loads);
    std::vector<std::string> inputs = {"q", "qd", "qdd"};
    if (robot.floating_base) inputs.insert(inputs.end(), {"base_velocity", "base_acceleration"});
    const Program statements = symbolic::with_derivatives(plain, inputs);
    const Arrays<double> state = random_inputs(plain, seed);
    const Arrays<double> found = symbolic::interpret(recursion, state);
    const Arrays<double> expected = symbolic::interpret(statements, state);
    for (const std::string& input : inputs) {
      const std::vector<double> block = stacked(expected, input, robot.floating_base ? 6 : 0, robot.dof());
      expect_near(found.at("d_" + input), block, "seed " + std::to_string(seed) + ": " + input);
    }
  }
}

// The gradient is the transpose of these derivatives times the weights.
TEST(Derivatives, GradientOfInverseDynamics) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = random_robot(seed, {.max_joints = 12});
    const Program recursion = algorithm::inverse_dynamics_derivatives(robot, "f", Loads::gravity_and_external);
    const Program gradient = algorithm::inverse_dynamics_gradient(robot, "f", Loads::gravity_and_external);
    Arrays<double> state = random_inputs(gradient, seed);
    const Arrays<double> found = symbolic::interpret(gradient, state);
    const std::vector<double> weights = state.at("weights");
    state.erase("weights");
    const Arrays<double> derivatives = symbolic::interpret(recursion, state);
    expect_near(found.at("tau"), derivatives.at("tau"), "tau");
    std::vector<std::string> inputs = {"q", "qd", "qdd"};
    if (robot.floating_base) inputs.insert(inputs.end(), {"base_velocity", "base_acceleration"});
    for (const std::string& input : inputs) {
      const std::vector<double>& columns = derivatives.at("d_" + input);
      std::vector<double> expected(columns.size() / weights.size());
      for (std::size_t k = 0; k < columns.size(); ++k)
        expected[k / weights.size()] += weights[k % weights.size()] * columns[k];
      expect_near(found.at("d_" + input), expected, "seed " + std::to_string(seed) + ": " + input);
    }
  }
}

}  // namespace
}  // namespace robcogen::numeric
