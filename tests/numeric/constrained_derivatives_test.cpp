// Derivatives of the dynamics with contacts agree with the exact differentiation of each statement of these dynamics,
// in long double, on random robots; and loops over right-hand sides give what code without loops gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithm/dynamics/contacts.h"
#include "algorithm/kinematics/loop_functions.h"
#include "coupled_robot.h"
#include "dice.h"
#include "document_tree.h"
#include "iterative_robot.h"
#include "looped_robot.h"
#include "random_drives.h"
#include "random_robot.h"
#include "spherical_robot.h"
#include "symbolic/derivative.h"
#include "symbolic/interpret.h"
#include "volume.h"

namespace robcogen::numeric::constrained_derivatives_test {
namespace {

using algorithm::ContactFrames;
using algorithm::Loads;
using model::KinematicTree;
using symbolic::Program;
using Real = long double;
using Values = std::vector<Real>;
using Arrays = symbolic::Arrays<Real>;

constexpr Real kNear = 1e-10L;  // of the largest element of a block

ContactFrames random_contacts(const KinematicTree& tree, Dice& dice) {
  std::vector<model::Frame> frames;
  for (const model::Frame& frame : tree.frames())
    if (tree.floating_base || tree.link_of(frame) != 0) frames.push_back(frame);
  ContactFrames contacts;
  const int count = 1 + dice.below(3);
  for (int c = 0; c < count && !frames.empty(); ++c) {
    const int k = dice.below(static_cast<int>(frames.size()));
    contacts.push_back({frames[static_cast<std::size_t>(k)], dice.chance(0.4)});
    frames.erase(frames.begin() + k);
  }
  return contacts;
}

// Numbers between -1 and 1; contacts are closed or open and compliant, quaternions have length one.
Arrays random_state(const Program& program, Dice& dice) {
  Arrays state;
  for (const symbolic::InputArray& array : program.inputs) {
    Values& values = state[array.name];
    for (std::size_t k = 0; k < array.elements.size(); ++k) {
      if (array.role == symbolic::Role::contact_activity)
        values.push_back(dice.chance(0.7) ? 1 : 0);
      else if (array.role == symbolic::Role::contact_compliance)
        values.push_back(dice.between(0.1, 1));
      else if (array.role == symbolic::Role::parameters)
        values.push_back(dice.between(0.6, 1));
      else
        values.push_back(dice.between(-1, 1));
    }
    for (const int first : array.quaternions) {
      Real square = 0;
      for (int k = 0; k < 4; ++k) square += values[at(first + k)] * values[at(first + k)];
      for (int k = 0; k < 4; ++k) values[at(first + k)] /= std::sqrt(square);
    }
  }
  return state;
}

// The rows of results that belong together, column by column: `d_<input>` of each result, one below the other.
Values stacked(const Arrays& results, const std::vector<std::string>& of, const std::string& input) {
  Values rows;
  const std::size_t columns = results.at(of.front() + "_d_" + input).size() / results.at(of.front()).size();
  for (std::size_t c = 0; c < columns; ++c)
    for (const std::string& name : of) {
      const Values& block = results.at(name + "_d_" + input);
      const std::size_t size = results.at(name).size();
      for (std::size_t r = 0; r < size; ++r) rows.push_back(block[r + c * size]);
    }
  return rows;
}

void expect_near(const Values& found, const Values& expected, const std::string& what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  Real size = 1, error = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    size = std::max(size, std::abs(expected[k]));
    error = std::max(error, std::abs(found[k] - expected[k]));
  }
  EXPECT_LT(error, kNear * size) << what;
}

// The results that a language with loops computes.
Arrays solved_in_columns(const symbolic::SolvedColumns& solved, const Arrays& state) {
  Arrays results = symbolic::interpret(solved.right_sides, state);
  for (const symbolic::SolvedColumns::Block& block : solved.blocks) {
    const symbolic::OutputArray& output = solved.right_sides.outputs[at(block.output)];
    Values& columns = results.at(output.name);
    for (int c = 0; c < block.columns; ++c) {
      const auto begin = columns.begin() + c * output.rows;
      const Values x =
          symbolic::interpret(
              solved.solution, Arrays{{"factor", results.at("factor")}, {"b", {begin, begin + output.rows}}})
              .at("x");
      std::copy(x.begin(), x.end(), begin);
    }
  }
  return results;
}

Program differentiated(const Program& program, std::vector<std::string> inputs, const KinematicTree& tree) {
  std::erase_if(inputs, [&](const std::string& input) {
    return std::none_of(program.inputs.begin(), program.inputs.end(), [&](const auto& a) { return a.name == input; });
  });
  return *symbolic::with_derivatives(
      program, inputs, symbolic::DerivativeMode::forward, 4'000'000, algorithm::follower_rates(tree));
}

void expect_blocks(
    const Arrays& found,
    const Arrays& expected,
    const std::vector<std::string>& of,
    const std::vector<std::string>& inputs) {
  for (const std::string& value : of) expect_near(found.at(value), expected.at(value), value);
  for (const std::string& input : inputs)
    if (input != "gravity" && expected.count(of.front() + "_d_" + input) > 0)
      expect_near(found.at("d_" + input), stacked(expected, of, input), "d_" + input);
}

void expect_in_columns(const Program& whole, const symbolic::SolvedColumns& solved, const Arrays& state) {
  const Arrays expected = symbolic::interpret(whole, state), found = solved_in_columns(solved, state);
  for (const symbolic::OutputArray& output : whole.outputs)
    expect_near(found.at(output.name), expected.at(output.name), "in columns: " + output.name);
}

std::vector<std::string> with_base(bool floating, std::vector<std::string> names, const char* base) {
  if (floating) names.insert(names.begin(), base);
  return names;
}

void check_forward_dynamics(const KinematicTree& tree, const ContactFrames& contacts, Dice& dice) {
  const Loads loads = dice.chance(0.5) ? Loads::gravity : Loads::gravity_and_external;
  const Program plain = algorithm::constrained_forward_dynamics(tree, contacts, "f", loads);
  const Program whole = algorithm::constrained_forward_dynamics_derivatives(tree, contacts, "f", loads);
  const std::vector<std::string> inputs = {"q", "qd", "tau", "base_velocity", "contact_acceleration", "gravity"};
  const Arrays state = random_state(plain, dice);
  Arrays expected = symbolic::interpret(differentiated(plain, inputs, tree), state);
  const Arrays found = symbolic::interpret(whole, state);
  const auto of = with_base(tree.floating_base, {"qdd", "contact_wrenches"}, "base_acceleration");
  expect_blocks(found, expected, of, inputs);
  expect_in_columns(
      whole, algorithm::constrained_forward_dynamics_derivatives_in_columns(tree, contacts, "f", loads), state);
  if (!tree.floating_base) return;
  // A turn of the base changes gravity by g x turn.
  const Values by_gravity = stacked(expected, of, "gravity"), &g = state.at("gravity");
  const std::size_t rows = by_gravity.size() / 3;
  Values by_turn;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t r = 0; r < rows; ++r) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      by_turn.push_back(g[j] * by_gravity[r + i * rows] - g[i] * by_gravity[r + j * rows]);
    }
  expect_near(found.at("d_base_rotation"), by_turn, "d_base_rotation");
}

void check_impact(const KinematicTree& tree, const ContactFrames& contacts, Dice& dice) {
  const Program plain = algorithm::impact(tree, contacts, "f");
  const Program whole = algorithm::impact_derivatives(tree, contacts, "f");
  const std::vector<std::string> inputs = {"q", "qd", "base_velocity", "restitution"};
  const Arrays state = random_state(plain, dice);
  const auto of = with_base(tree.floating_base, {"qd_after", "contact_impulses"}, "base_velocity_after");
  expect_blocks(
      symbolic::interpret(whole, state), symbolic::interpret(differentiated(plain, inputs, tree), state), of, inputs);
  expect_in_columns(whole, algorithm::impact_derivatives_in_columns(tree, contacts, "f"), state);
}

// Returns whether the robot has functions of contacts.
bool check(const KinematicTree& tree, std::uint64_t seed) {
  Dice dice(seed + 5);
  const ContactFrames contacts = random_contacts(tree, dice);
  if (contacts.empty() || tree.inertia_defects.is_singular()) return false;
  check_forward_dynamics(tree, contacts, dice);
  check_impact(tree, contacts, dice);
  return true;
}

TEST(ConstrainedDerivatives, OfRandomRobots) {
  int compared = 0, floating = 0;
  for (int i = 0; i < robot_count() / 10; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    KinematicTree tree = random_robot(seed, {.max_joints = 8});
    if (seed % 3 == 0) tree = with_random_drives(std::move(tree), seed);
    if (seed % 4 == 1) tree = coupled(tree, seed, seed % 8 == 1).robot;
    const bool is_done = check(tree, seed);
    compared += is_done ? 1 : 0;
    floating += is_done && tree.floating_base ? 1 : 0;
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << describe(tree);
      return;
    }
  }
  EXPECT_GT(compared, robot_count() / 20);
  EXPECT_GT(floating, robot_count() / 60);
}

TEST(ConstrainedDerivatives, OfRobotsWithSphericalJoints) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const KinematicTree tree = with_spherical_joints(random_robot(seed, {.max_joints = 4}), seed);
    compared += !tree.spherical_joints().empty() && check(tree, seed) ? 1 : 0;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(compared, 8);
}

TEST(ConstrainedDerivatives, OfRobotsWithLoops) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::optional<KinematicTree> tree = looped_tree(seed);
    compared += tree && check(*tree, seed) ? 1 : 0;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(compared, 4);
  SCOPED_TRACE("closed by iteration");
  EXPECT_TRUE(check(tree_of_text(iterative_robots().front().document), 1));
}

// The inverse of the matrix of the system is symmetric up to the sign of the forces.
TEST(ConstrainedDerivatives, ByForcesAndContactAccelerationsAreSymmetric) {
  KinematicTree tree;
  for (std::uint64_t seed = 0; !tree.floating_base; ++seed)
    tree = random_robot(seed, {.min_joints = 6, .max_joints = 8, .odd_documents = false});
  Dice dice(3);
  const ContactFrames contacts = random_contacts(tree, dice);
  const Program program = algorithm::constrained_forward_dynamics_derivatives(tree, contacts, "f", Loads::gravity);
  const Arrays found = symbolic::interpret(program, random_state(program, dice));
  const std::size_t n = at(tree.dof()), m = found.at("contact_wrenches").size(), rows = 6 + n + m;
  const auto element = [&](std::size_t row, std::size_t column) {
    return column < n ? found.at("d_tau")[6 + row + column * rows]
                      : found.at("d_contact_acceleration")[6 + row + (column - n) * rows];
  };
  for (std::size_t r = 0; r < n + m; ++r)
    for (std::size_t c = 0; c < r; ++c) {
      const Real sign = (r < n) == (c < n) ? 1 : -1;
      EXPECT_NEAR(static_cast<double>(element(r, c)), static_cast<double>(sign * element(c, r)), 1e-12)
          << r << " " << c;
    }
}

}  // namespace
}  // namespace robcogen::numeric::constrained_derivatives_test
