// Recursive derivatives agree with the exact differentiation of each statement, on random robots.
#include <gtest/gtest.h>

#include <optional>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/dynamics/dynamics.h"
#include "coupled_robot.h"
#include "dice.h"
#include "random_drives.h"
#include "random_robot.h"
#include "symbolic/derivative.h"
#include "symbolic/interpret.h"

namespace robcogen::numeric::derivatives_test {
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

// Returns the rows of the base followed by those of the joints.
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

// Some robots have rotors and other drives, some coupled joints, some both.
model::KinematicTree robot_with_drives_or_couplings(std::uint64_t seed) {
  model::KinematicTree robot = random_robot(seed, {.max_joints = 12});
  if (seed % 3 == 0) robot = with_random_drives(std::move(robot), seed);
  return seed % 4 == 0 ? coupled(robot, seed).robot : robot;
}

TEST(Derivatives, OfInverseDynamicsByBothWays) {
  constexpr std::uint64_t kMany = 2000;
  for (std::uint64_t seed = 0; seed < kMany; ++seed) {
    const model::KinematicTree robot = robot_with_drives_or_couplings(seed);
    const Loads loads = seed % 2 == 0 ? Loads::gravity : Loads::gravity_and_external;
    const Program recursion = algorithm::inverse_dynamics_derivatives(robot, "f", loads);
    const Program plain = algorithm::newton_euler(robot, "f", loads);
    std::vector<std::string> inputs = {"q", "qd", "qdd"};
    if (robot.floating_base) inputs.insert(inputs.end(), {"base_velocity", "base_acceleration", "base_rotation"});
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
    const model::KinematicTree robot = robot_with_drives_or_couplings(seed);
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

// ---- Derivatives of forward dynamics in a loop over right-hand sides.

// Returns the inputs of one limb's lane.
Arrays<double> inputs_of_limb(
    const symbolic::SolvedColumns::Limbs& limbs,
    int limb,
    const std::vector<double>& factor,
    const std::vector<double>& b) {
  const auto count = static_cast<std::size_t>(limbs.count), own_rows = static_cast<std::size_t>(limbs.joints);
  const std::size_t common = b.size() - count * own_rows, first = common + static_cast<std::size_t>(limb) * own_rows;
  Arrays<double> inputs = {{"factor", factor}, {"is_limb", std::vector<double>(count)}};
  inputs["is_limb"][static_cast<std::size_t>(limb)] = 1;
  for (std::size_t k = static_cast<std::size_t>(limb); k < limbs.own.size(); k += count)
    inputs["own"].push_back(factor[static_cast<std::size_t>(limbs.own[k])]);
  for (std::size_t row = 0; row < b.size(); ++row) {
    const bool is_seen = row < common || (row >= first && row < first + own_rows);
    if (is_seen)
      inputs["b"].push_back(b[row]);
    else
      EXPECT_EQ(b[row], 0) << "row " << row << " of limb " << limb;
  }
  return inputs;
}

// Returns the results that a language with loops computes.
Arrays<double> solved_in_columns(const symbolic::SolvedColumns& solved, const Arrays<double>& state) {
  Arrays<double> results = symbolic::interpret(solved.right_sides, state);
  for (const symbolic::SolvedColumns::Block& block : solved.blocks) {
    const symbolic::OutputArray& output = solved.right_sides.outputs[static_cast<std::size_t>(block.output)];
    std::vector<double>& columns = results.at(output.name);
    for (int c = 0; c < block.columns; ++c) {
      const auto begin = columns.begin() + c * output.rows;
      const std::vector<double> b(begin, begin + output.rows);
      const Arrays<double> inputs =
          block.of_limbs ? inputs_of_limb(*solved.limbs, c / solved.limbs->joints, results.at("factor"), b)
                         : Arrays<double>{{"factor", results.at("factor")}, {"b", b}};
      const Program& solution = block.of_limbs ? solved.limbs->solution : solved.solution;
      const std::vector<double> x = symbolic::interpret(solution, inputs).at("x");
      std::copy(x.begin(), x.end(), begin);
    }
  }
  return results;
}

TEST(Derivatives, OfForwardDynamicsInColumns) {
  int robots = 0;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = robot_with_drives_or_couplings(seed);
    if (!algorithm::is_available(robot, "forward_dynamics_derivatives")) continue;
    ++robots;
    const Loads loads = seed % 2 == 0 ? Loads::gravity : Loads::gravity_and_external;
    const Program whole = algorithm::forward_dynamics_derivatives(robot, "f", loads);
    const symbolic::SolvedColumns solved = algorithm::forward_dynamics_derivatives_in_columns(robot, "f", loads);
    const Arrays<double> state = random_inputs(whole, seed);
    const Arrays<double> expected = symbolic::interpret(whole, state), found = solved_in_columns(solved, state);
    for (const symbolic::OutputArray& output : whole.outputs)
      expect_near(found.at(output.name), expected.at(output.name), "seed " + std::to_string(seed) + ": " + output.name);
  }
  EXPECT_GT(robots, kRobots / 2);
}

// Returns a floating base that carries copies of one limb.
model::KinematicTree robot_with_limbs(std::uint64_t seed, int count) {
  const model::KinematicTree limb = random_robot(seed, {.max_joints = 5, .odd_documents = false});
  model::KinematicTree robot = random_robot(seed, {.max_joints = 1, .odd_documents = false});
  robot.floating_base = true;
  robot.joints.clear();
  robot.links.resize(1);
  robot.links[0].child_joints.clear();
  robot.links[0].inertia = limb.links.back().inertia;
  Dice dice(seed);
  for (int k = 0; k < count; ++k) {
    const int joints = static_cast<int>(robot.joints.size());
    const auto moved = [&](int link) { return link == 0 ? 0 : link + joints; };
    for (model::Joint joint : limb.joints) {
      joint.name += "_" + std::to_string(k);
      if (joint.parent == 0)
        for (model::Quantity& t : joint.placement.translation) t = model::Quantity(dice.between(-1, 1));
      joint.parent = moved(joint.parent);
      joint.child = moved(joint.child);
      robot.joints.push_back(std::move(joint));
    }
    for (std::size_t l = 0; l < limb.links.size(); ++l) {
      std::vector<int> children = limb.links[l].child_joints;
      for (int& joint : children) joint += joints;
      if (l == 0) {
        robot.links[0].child_joints.insert(robot.links[0].child_joints.end(), children.begin(), children.end());
        continue;
      }
      model::Link link = limb.links[l];
      link.name += "_" + std::to_string(k);
      link.parent_joint += joints;
      link.child_joints = children;
      robot.links.push_back(std::move(link));
    }
  }
  return seed % 4 == 3 ? with_random_drives(std::move(robot), seed) : robot;
}

// Solves one column of every limb at a time.
TEST(Derivatives, OfForwardDynamicsInColumnsOfLimbs) {
  int robots = 0, without_drives = 0;
  for (std::uint64_t seed = 0; seed < kRobots / 2; ++seed) {
    const model::KinematicTree robot = robot_with_limbs(seed, seed % 3 == 0 ? 2 : 4);
    const Program whole = algorithm::forward_dynamics_derivatives(robot, "f", Loads::gravity);
    const symbolic::SolvedColumns solved =
        algorithm::forward_dynamics_derivatives_in_columns(robot, "f", Loads::gravity);
    if (solved.limbs) {
      ++robots;
      // A tendon between limbs makes columns of d_q and d_qd belong to several limbs.
      const auto blocks =
          std::count_if(solved.blocks.begin(), solved.blocks.end(), [](const auto& b) { return b.of_limbs; });
      EXPECT_TRUE(blocks == 3 || (blocks >= 1 && !robot.tendons.empty())) << blocks;
    } else if (seed % 4 != 3) {
      ++without_drives;
    }
    const Arrays<double> state = random_inputs(whole, seed);
    const Arrays<double> expected = symbolic::interpret(whole, state), found = solved_in_columns(solved, state);
    for (const symbolic::OutputArray& output : whole.outputs)
      expect_near(found.at(output.name), expected.at(output.name), "seed " + std::to_string(seed) + ": " + output.name);
  }
  EXPECT_GT(robots, kRobots / 5);
  EXPECT_LT(without_drives, kRobots / 5) << "limbs that branch at the base";
}

TEST(Derivatives, OfInverseDynamicsOfAFreeBaseInColumns) {
  int robots = 0;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = robot_with_drives_or_couplings(seed);
    if (!robot.floating_base || robot.inertia_defects.locked_base) continue;
    ++robots;
    const Loads loads = seed % 2 == 0 ? Loads::gravity : Loads::gravity_and_external;
    const Program whole = algorithm::unactuated_base_inverse_dynamics_derivatives(robot, "f", loads);
    const symbolic::SolvedColumns solved =
        algorithm::unactuated_base_inverse_dynamics_derivatives_in_columns(robot, "f", loads);
    const Arrays<double> state = random_inputs(whole, seed);
    const Arrays<double> expected = symbolic::interpret(whole, state), found = solved_in_columns(solved, state);
    for (const symbolic::OutputArray& output : whole.outputs)
      expect_near(found.at(output.name), expected.at(output.name), "seed " + std::to_string(seed) + ": " + output.name);
  }
  EXPECT_GT(robots, kRobots / 4);
}

// Fourth-order central differences in long double of the program's results, with respect to element `k` of an input.
std::vector<long double> difference(
    const Program& program,
    const Arrays<long double>& state,
    const symbolic::OutputArray& output,
    const std::string& input,
    std::size_t k) {
  constexpr long double kStep = 1e-4L;
  const auto at = [&](int steps) {
    Arrays<long double> moved = state;
    moved.at(input)[k] += steps * kStep;
    return symbolic::interpret(program, moved).at(output.name);
  };
  const std::vector<long double> a = at(1), b = at(-1), c = at(2), d = at(-2);
  std::vector<long double> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back((8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * kStep));
  return result;
}

// Checks the derivatives of one function with respect to all of its inputs; returns the number of blocks.
int expect_derivatives(const symbolic::Function& f, std::uint64_t seed) {
  std::vector<std::string> inputs;
  // Quaternions, such as that of a base pose, are left out: their columns are rotations, which the tests of spherical
  // joints compare.
  for (const symbolic::InputArray& array : f.program.inputs)
    if (array.quaternions.empty()) inputs.push_back(array.name);
  const std::optional<Program> derivatives =
      symbolic::with_derivatives(f.program, inputs, symbolic::DerivativeMode::cheaper, 1'000'000);
  EXPECT_TRUE(derivatives) << f.name;
  if (!derivatives) return 0;
  Arrays<long double> state;
  for (const auto& [name, values] : random_inputs(f.program, seed)) state[name] = {values.begin(), values.end()};
  const Arrays<long double> found = symbolic::interpret(*derivatives, state);
  int blocks = 0;
  for (const symbolic::OutputArray& output : f.program.outputs) {
    for (const std::string& input : inputs) {
      const bool is_only = f.program.outputs.size() == 1 && output.name != "d_" + input;
      const auto& block = found.at((is_only ? "" : output.name + "_") + "d_" + input);
      const std::size_t rows = found.at(output.name).size();
      EXPECT_EQ(block.size(), rows * state.at(input).size());
      ++blocks;
      for (std::size_t k = 0; k < state.at(input).size(); ++k) {
        const std::vector<long double> expected = difference(f.program, state, output, input, k);
        long double scale = 1, error = 0;
        for (std::size_t r = 0; r < rows; ++r) {
          scale = std::max(scale, std::abs(expected[r]));
          error = std::max(error, std::abs(expected[r] - block[r + k * rows]));
        }
        EXPECT_LT(error, 1e-9L * scale) << "seed " << seed << ", " << f.name << ": " << output.name << " by " << input;
      }
    }
  }
  return blocks;
}

// Second derivatives of weights times forces are derivatives of their gradient; the blocks of q and of qd are
// symmetric.
TEST(Derivatives, SecondOfInverseDynamics) {
  constexpr std::uint64_t kFew = 60;
  for (std::uint64_t seed = 0; seed < kFew; ++seed) {
    const model::KinematicTree robot = robot_with_drives_or_couplings(seed);
    const Program gradient = algorithm::inverse_dynamics_gradient(robot, "f", Loads::gravity_and_external);
    const Program second = algorithm::inverse_dynamics_second_derivatives(robot, "f", Loads::gravity_and_external);
    Arrays<long double> state;
    for (const auto& [name, values] : random_inputs(gradient, seed)) state[name] = {values.begin(), values.end()};
    const Arrays<long double> found = symbolic::interpret(second, state);
    std::vector<std::string> inputs = {"q", "qd", "qdd"};
    if (robot.floating_base) inputs.insert(inputs.end(), {"base_velocity", "base_acceleration"});
    for (const symbolic::OutputArray& output : gradient.outputs) {
      if (!output.name.starts_with("d_")) continue;
      for (const std::string& input : inputs) {
        const auto block = found.find(output.name + "_" + input);
        const auto transposed = found.find("d_" + input + "_" + output.name.substr(2));
        const std::size_t rows = found.at(output.name).size(), columns = state.at(input).size();
        for (std::size_t k = 0; k < columns; ++k) {
          const std::vector<long double> expected = difference(gradient, state, output, input, k);
          for (std::size_t r = 0; r < rows; ++r) {
            const long double value = block != found.end()        ? block->second[r + k * rows]
                                      : transposed != found.end() ? transposed->second[k + r * columns]
                                                                  : 0.0L;
            ASSERT_NEAR(
                static_cast<double>(value - expected[r]), 0.0, 1e-8 * (1 + std::abs(static_cast<double>(value))))
                << "seed " << seed << ": " << output.name << " by " << input << ' ' << r << ' ' << k;
          }
        }
      }
    }
  }
}

// Every function, with respect to every input, in the cheaper mode.
TEST(Derivatives, OfEveryFunctionByEveryInput) {
  constexpr std::uint64_t kFew = 12;
  int blocks = 0;
  for (std::uint64_t seed = 0; seed < kFew; ++seed) {
    const model::KinematicTree robot = random_robot(seed, {.max_joints = 4});
    const std::vector<model::Frame> frames = robot.frames();
    const model::FramePair pair = {frames.front(), frames.back()};
    for (const std::string& group : algorithm::groups()) {
      for (const symbolic::Function& f : algorithm::functions(robot, {{pair}, {pair}}, group)) {
        const bool divides_by_inertia = group.starts_with("forward_dynamics") || f.scope == "inertia_factor";
        const bool is_long = group == "inverse_dynamics_second_derivatives";
        if (!divides_by_inertia && !is_long) blocks += expect_derivatives(f, seed);
      }
    }
  }
  EXPECT_GT(blocks, 1000);
}

}  // namespace
}  // namespace robcogen::numeric::derivatives_test
