// Robots whose loops no formula closes: spatial loops, loops with frames that slide or are welded, and loops that must
// be closed together.
#include <gtest/gtest.h>

#include "algorithm/kinematics/loop_functions.h"
#include "document_tree.h"
#include "import/kinematics.h"
#include "interpreted_robot.h"
#include "iterative_robot.h"
#include "language/kinematics/document.h"
#include "random_robot.h"
#include "reference_tables.h"
#include "robcogen/reference/loops.h"
#include "symbolic/derivative.h"

namespace robcogen::numeric::iterative_loops_test {
namespace {

using reference::Real;
using reference::Vector;

Names names_of(const model::KinematicTree& tree, const std::vector<int>& joints) {
  Names names;
  for (const int joint : joints) names.push_back(tree.joints[static_cast<std::size_t>(joint)].name);
  return names;
}

class IterativeLoops : public testing::TestWithParam<IterativeRobot> {};

TEST_P(IterativeLoops, HaveTheseCoordinates) {
  const model::KinematicTree tree = tree_of_text(GetParam().document);
  ASSERT_EQ(tree.closures.size(), 1U);
  EXPECT_EQ(tree.closures.front().method, model::Closure::Method::iterative);
  EXPECT_EQ(names_of(tree, tree.coordinates()), GetParam().coordinates);
  EXPECT_EQ(names_of(tree, tree.followers_in_q()), GetParam().followers);
}

TEST_P(IterativeLoops, AgreeWithTheReference) {
  const model::KinematicTree tree = tree_of_text(GetParam().document);
  for (const bool is_optimised : {false, true}) {
    const InterpretedRobot robot(
        tree, random_desired(7, tree), is_optimised ? all_steps() : std::vector<std::string>{});
    EXPECT_EQ(check_all(robot, 3, 4).failure_report(), "");
  }
}

// The iteration starts with followers slightly off their closed positions.
TEST_P(IterativeLoops, CloseInAFewSteps) {
  const model::KinematicTree tree = tree_of_text(GetParam().document);
  const InterpretedRobot robot(tree, {}, all_steps(), {}, {}, {"transforms"});
  const reflection::Robot tables = robot.tables();
  std::mt19937_64 engine(11);
  for (int i = 0; i < 10; ++i) {
    reference::Sample sample;
    const reference::AtLoops closed = draw(engine, tables, sample);
    const std::vector<double> wanted = sample.motion.q.values();
    std::vector<double> guess = wanted;
    for (std::size_t k = static_cast<std::size_t>(tables.dof()); k < guess.size(); ++k)
      guess[k] += reference::uniform(engine, 0.05);
    const std::vector<double> found = robot.run("close_loops", {}, {{"q", guess}}).at("q");
    for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(found[k], wanted[k], 1e-10) << k;
    const std::vector<double> all = robot.run("joint_positions", {}, {{"q", found}}).at("positions");
    const std::vector<double> open = robot.run("loop_error", {}, {{"positions", all}}).at("error");
    for (const double e : open) EXPECT_NEAR(e, 0.0, 1e-10);
  }
}

// Compares with sixth-order differences in long double, through positions whose loops are closed again.
TEST_P(IterativeLoops, HaveDerivativesAlongClosedPositions) {
  constexpr Real kStep = 2e-4L, kSame = 1e-9L;
  model::KinematicTree tree = tree_of_text(GetParam().document);
  tree.floating_base = false;
  const InterpretedRobot robot(
      tree, {}, {}, {}, {},
      {"inverse_dynamics", "forward_dynamics", "energy", "inverse_dynamics_gradient",
       "inverse_dynamics_second_derivatives"});
  const auto with_derivatives = [&](const std::string& name) {
    const symbolic::Program& program = robot.program(name);
    return *symbolic::with_derivatives(
        program, {"q"}, symbolic::DerivativeMode::forward, 1'000'000, algorithm::follower_rates(tree));
  };
  const reflection::Robot tables = robot.tables();
  std::mt19937_64 engine(23);
  reference::Sample sample;
  const reference::AtLoops closed = draw(engine, tables, sample);
  const auto values = [](const Vector<Real>& v) { return std::vector<Real>(v.values().begin(), v.values().end()); };
  const Vector<Real> weights = reference::uniform_vector(engine, tables.dof(), 1).cast<Real>();
  const auto results = [&](const symbolic::Program& program, int coordinate, int steps) {
    reference::Motion<Real> motion = reference::cast<Real>(sample.motion);
    motion.q(tables.position_of(coordinate)) += static_cast<Real>(steps) * kStep;
    closed.near(motion);
    symbolic::Arrays<Real> inputs = {
        {"q", values(motion.q)},
        {"qd", values(motion.qd)},
        {"qdd", values(motion.qdd)},
        {"tau", values(motion.qdd)},
        {"weights", values(weights)}};
    for (const model::Parameter& p : tree.parameters)
      inputs["parameters"].push_back(static_cast<Real>(p.default_value.value_or(1.0)));
    std::erase_if(inputs, [&](const auto& given) {
      return std::none_of(
          program.inputs.begin(), program.inputs.end(), [&](const auto& array) { return array.name == given.first; });
    });
    return symbolic::interpret(program, inputs);
  };
  const auto expect_derivative = [&](const symbolic::Program& program, const std::string& of,
                                     const symbolic::Program& derivative, const std::string& block) {
    const std::vector<Real> here = results(program, 0, 0).at(of), found = results(derivative, 0, 0).at(block);
    ASSERT_EQ(found.size(), here.size() * static_cast<std::size_t>(tables.dof())) << program.name;
    Real size = 1;
    for (const Real x : found) size = std::max(size, std::abs(x));
    for (int c = 0; c < tables.dof(); ++c) {
      std::vector<Real> slope(here.size());
      for (const auto& [steps, weight] : {std::pair(1, 45), {2, -9}, {3, 1}})
        for (const int sign : {1, -1}) {
          const std::vector<Real> there = results(program, c, sign * steps).at(of);
          for (std::size_t r = 0; r < here.size(); ++r)
            slope[r] += static_cast<Real>(sign * weight) * there[r] / (60 * kStep);
        }
      for (std::size_t r = 0; r < here.size(); ++r)
        EXPECT_NEAR(
            static_cast<double>(found[static_cast<std::size_t>(c) * here.size() + r]), static_cast<double>(slope[r]),
            static_cast<double>(kSame * size))
            << program.name << " " << block << " " << r << " " << c;
    }
  };
  for (const auto& [name, output] :
       {std::pair("inverse_dynamics", "tau"), {"forward_dynamics", "qdd"}, {"kinetic_energy", "T"}})
    expect_derivative(robot.program(name), output, with_derivatives(name), "d_q");
  const symbolic::Program& gradient = robot.program("inverse_dynamics_gradient");
  const symbolic::Program& second = robot.program("inverse_dynamics_second_derivatives");
  for (const std::string of : {"d_q", "d_qd", "d_qdd"}) expect_derivative(gradient, of, second, of + "_q");
}

// If no position of the followers closes the loops, their positions are NaN.
TEST(IterativeLoops, SayThatTheyDoNotClose) {
  const model::KinematicTree tree = tree_of_text(iterative_robots()[3].document);
  const InterpretedRobot robot(tree, {}, {}, {}, {}, {"transforms"});
  std::vector<double> q(6);
  q[0] = 2.5, q[1] = -2.5, q[2] = 0.4;
  for (std::size_t k = 3; k < 6; ++k) q[k] = 0.1;
  const std::vector<double> found = robot.run("close_loops", {}, {{"q", q}}).at("q");
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found[k], q[k]);
  for (std::size_t k = 3; k < 6; ++k) EXPECT_TRUE(std::isnan(found[k])) << found[k];
}

// Axes that are off by rounding: the same joints follow, and they reach the same positions.
TEST(IterativeLoops, DoNotMindRoundingNoise) {
  const std::string text = cut_rod("independent { a }");
  std::string noisy = text;
  for (const auto& [from, to] :
       {std::pair("0.0, 0.0, -0.8", "3e-11, -3e-18, -0.8"), {"0.0, 0.0, 1.4", "0.0, 4e-12, 1.4"}})
    noisy.replace(noisy.find(from), std::string(from).size(), to);
  const model::KinematicTree exact = tree_of_text(text), noise = tree_of_text(noisy);
  EXPECT_EQ(names_of(noise, noise.followers_in_q()), names_of(exact, exact.followers_in_q()));
  const auto closed = [](const model::KinematicTree& tree) {
    const InterpretedRobot robot(tree, {}, all_steps(), {}, {}, {"transforms"});
    std::vector<double> q = {0.02};
    for (const int follower : tree.followers_in_q()) q.push_back(model::evaluate(tree.coupling_of(follower)->offset));
    return robot.run("close_loops", {}, {{"q", q}}).at("q");
  };
  const std::vector<double> wanted = closed(exact), found = closed(noise);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(found[k], wanted[k], 1e-9) << k;
}

// The sine of half a turn is zero, too, like that of no turn.
TEST(IterativeLoops, AreNotClosedTheOtherWayRound) {
  Diagnostics diagnostics;
  const std::string text = cut_rod("independent { a }", "PI, PI/2.0, 0.0");
  const auto source = std::make_shared<const Source>("turned.kindsl", text);
  EXPECT_FALSE(import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics));
  EXPECT_NE(diagnostics.render().find("loop-cannot-close"), std::string::npos) << diagnostics.render();
}

INSTANTIATE_TEST_SUITE_P(
    Mechanism,
    IterativeLoops,
    testing::ValuesIn(iterative_robots()),
    [](const testing::TestParamInfo<IterativeRobot>& of) { return of.param.name; });

}  // namespace
}  // namespace robcogen::numeric::iterative_loops_test
