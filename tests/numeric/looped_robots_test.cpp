// Robots with loops: all functions against the reference, which closes loops by Newton's method; and the motion against
// that of the tree whose loops are held closed by forces.
#include <gtest/gtest.h>

#include "import/kinematics.h"
#include "interpreted_robot.h"
#include "language/kinematics/document.h"
#include "looped_robot.h"
#include "random_robot.h"
#include "reference_tables.h"
#include "robcogen/reference/loops.h"
#include "volume.h"

namespace robcogen::numeric {
namespace {

using reference::Matrix;
using reference::Real;
using reference::Vector;

constexpr int kShards = 5;

int looped_count() {
  return robot_count() / 40;
}

// nullopt for the few random loops that do not close.
std::optional<model::KinematicTree> looped(std::uint64_t seed) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>("looped.kindsl", looped_document(seed));
  auto tree = import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics);
  for (const Diagnostic& d : diagnostics.all()) {
    const bool is_expected = d.severity != Severity::error || d.code == "loop-cannot-close";
    EXPECT_TRUE(is_expected) << seed << "\n" << diagnostics.render() << looped_document(seed);
  }
  return tree;
}

// A little off their defaults.
std::vector<double> values_of(const model::KinematicTree& tree) {
  std::vector<double> values;
  for (const model::Parameter& p : tree.parameters) values.push_back(1.02 * p.default_value.value_or(0.0));
  return values;
}

class LoopedRobots : public testing::TestWithParam<int> {};

TEST_P(LoopedRobots, AgreeWithTheReferenceAndWithThemselves) {
  for (int i = GetParam(); i < looped_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const auto tree = looped(seed);
    if (!tree) continue;
    const InterpretedRobot robot(
        *tree, random_desired(seed, *tree), i % 3 == 0 ? all_steps() : std::vector<std::string>{}, values_of(*tree));
    EXPECT_EQ(check_all(robot, seed, 2).failure_report(), "") << "seed " << seed << "\n" << looped_document(seed);
    if (HasFailure()) return;
  }
}

// [H K'; K 0] [qdd; -f] = [tau - bias; -dK/dt qd], whose solution is that of the coordinates for forces on them alone.
TEST_P(LoopedRobots, MoveAsTheirTreesWithForcesInTheLoops) {
  constexpr double kSame = 1e-10;
  for (int i = GetParam(); i < looped_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    auto tree = looped(seed);
    if (!tree) continue;
    tree->floating_base = false;
    tree->uses_passive_forces = false;
    const InterpretedRobot robot(*tree, {}, {}, values_of(*tree));
    const reflection::Robot tables = robot.tables();
    std::mt19937_64 engine(seed);
    reference::Sample sample;
    const reference::AtLoops closed = draw(engine, tables, sample);
    const reflection::Robot free = reference::with_free_joints(tables);
    reference::Motion<Real> all;
    all.q = reference::joint_positions(closed.robot(), sample.motion.q.cast<Real>());
    all.qd = reference::joint_rates(closed.robot(), sample.motion.qd.cast<Real>());
    all.qdd = Vector<Real>(tables.joints.size);
    const reference::LoopRows rows = reference::loop_rows(tables, all.q);
    EXPECT_LT(reference::largest(rows.error), 1e-14) << seed;
    Matrix<Real> K = rows.columns;
    for (int c = tables.dof(); c < tables.joints.size; ++c)
      if (!std::isnan(tables.couplings[c - tables.dof()].offset)) K = Matrix<Real>();
    if (K.empty()) continue;  // a coupling is another constraint
    const auto loads = reference::without_passive<Real>({0, 0, -9.81});
    const Vector<Real> bias = reference::inverse_dynamics_fully_actuated(free, all, loads).tau;
    const Matrix<Real> H = reference::joint_space_inertia(free, all.q);
    Vector<double> tau(tables.dof());
    for (int k = 0; k < tau.rows(); ++k) tau(k) = reference::uniform(engine, 5.0);
    Vector<Real> missing = Real(-1) * bias;
    for (int k = 0; k < tau.rows(); ++k) missing(k) += static_cast<Real>(tau(k));
    // f by the inertia that the rows see; those that say the same as others are held by a trace of compliance.
    const Matrix<Real> yielding = solve(H, transpose(K));
    Matrix<Real> W = K * yielding;
    const Real trace = reference::largest(W);
    for (int k = 0; k < W.rows(); ++k) W(k, k) += 1e-16L * trace;
    const Vector<Real> wanted_change = Real(-1) * reference::change_of_rates(tables, all.q, all.qd);
    const Vector<Real> f = solve(W, wanted_change - K * solve(H, missing));
    const Vector<Real> expected = solve(H, missing + transpose(K) * f).head(tables.dof());
    const Vector<double> found = robot.forward_dynamics(sample.motion, tau, {});
    EXPECT_LT(
        static_cast<double>(reference::largest(found.cast<Real>() - expected)),
        kSame * (1 + static_cast<double>(reference::largest(expected))))
        << seed << "\n"
        << looped_document(seed);
  }
}

// Weights times inverse dynamics, which the reference agrees with, by differences.
TEST_P(LoopedRobots, HaveTheGradientsOfTheirForces) {
  constexpr Real kStep = 1e-3L, kSame = 1e-9L;
  for (int i = GetParam(); i < looped_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    auto tree = looped(seed);
    if (!tree) continue;
    tree->floating_base = false;
    const InterpretedRobot robot(
        *tree, {}, {}, values_of(*tree), {}, {"inverse_dynamics", "inverse_dynamics_gradient"});
    const reflection::Robot tables = robot.tables();
    std::mt19937_64 engine(seed);
    reference::Sample sample;
    const reference::AtLoops closed = draw(engine, tables, sample);
    const auto values = [](const Vector<double>& v) { return std::vector<Real>(v.values().begin(), v.values().end()); };
    symbolic::Arrays<Real> inputs = {
        {"q", values(sample.motion.q)},
        {"qd", values(sample.motion.qd)},
        {"qdd", values(sample.motion.qdd)},
        {"weights", values(reference::uniform_vector(engine, tables.dof(), 1))}};
    const std::vector<double> parameters = values_of(*tree);
    if (!parameters.empty()) inputs["parameters"] = {parameters.begin(), parameters.end()};
    const auto gradient = symbolic::interpret(robot.programs().at("inverse_dynamics_gradient"), inputs);
    for (const char* input : {"q", "qd", "qdd"}) {
      for (std::size_t k = 0; k < inputs.at(input).size(); ++k) {
        const auto weighted = [&](int steps) {
          symbolic::Arrays<Real> moved = inputs;
          moved.at(input)[k] += static_cast<Real>(steps) * kStep;
          moved.erase("weights");
          const auto tau = symbolic::interpret(robot.programs().at("inverse_dynamics"), moved).at("tau");
          Real sum = 0;
          for (std::size_t j = 0; j < tau.size(); ++j) sum += inputs.at("weights")[j] * tau[j];
          return sum;
        };
        const Real slope =
            (45 * (weighted(1) - weighted(-1)) - 9 * (weighted(2) - weighted(-2)) + weighted(3) - weighted(-3)) /
            (60 * kStep);
        EXPECT_NEAR(
            static_cast<double>(gradient.at(std::string("d_") + input)[k]), static_cast<double>(slope),
            static_cast<double>(kSame * (1 + std::abs(slope) + std::abs(weighted(0)))))
            << seed << " " << input << k;
      }
    }
  }
}

TEST(LoopedDocuments, NearlyAllClose) {
  int closed = 0;
  for (int i = 0; i < looped_count(); ++i) closed += looped(static_cast<std::uint64_t>(i)) ? 1 : 0;
  EXPECT_GE(closed, looped_count() * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(Shard, LoopedRobots, testing::Range(0, kShards));

}  // namespace
}  // namespace robcogen::numeric
