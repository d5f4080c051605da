// Robots with loops: all functions compared with the reference, which closes loops by Newton's method; and the motion
// compared with that of the tree whose loops are held closed by forces.
#include <gtest/gtest.h>
#include <algorithm>

#include "interpreted_robot.h"
#include "looped_robot.h"
#include "open_loops.h"
#include "random_robot.h"
#include "reference_tables.h"
#include "robcogen/reference/loops.h"
#include "volume.h"

namespace robcogen::numeric::looped_robots_test {
namespace {

using reference::Matrix;
using reference::Real;
using reference::Vector;

constexpr int kShards = 5;

int looped_count() {
  return std::max(12, robot_count() / 40);
}

// The same robot on a fixed base, without springs and friction.
std::optional<model::KinematicTree> held(std::uint64_t seed) {
  auto tree = looped_tree(seed);
  if (tree) tree->floating_base = tree->uses_passive_forces = false;
  return tree;
}

class LoopedRobots : public testing::TestWithParam<int> {};

TEST_P(LoopedRobots, AgreeWithTheReferenceAndWithThemselves) {
  for (int i = GetParam(); i < looped_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const auto tree = looped_tree(seed);
    if (!tree) continue;
    const InterpretedRobot robot(
        *tree, random_desired(seed, *tree), i % 3 == 0 ? all_steps() : std::vector<std::string>{},
        values_near_defaults(*tree));
    EXPECT_EQ(check_all(robot, seed, 2).failure_report(), "") << "seed " << seed << "\n" << looped_document(seed);
    if (HasFailure()) return;
  }
}

// The coordinates move as in the solution of [H K'; K 0] [qdd; -f] = [tau - bias; -dK/dt qd], with forces tau on them
// only.
TEST_P(LoopedRobots, MoveAsTheirTreesWithForcesInTheLoops) {
  constexpr double kSame = 1e-10;
  for (int i = GetParam(); i < looped_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const auto tree = held(seed);
    if (!tree) continue;
    const InterpretedRobot robot(*tree, {}, {}, values_near_defaults(*tree));
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
    if (K.empty()) continue;  // couplings are further constraints
    const auto loads = reference::without_passive<Real>({0, 0, -9.81});
    const Vector<Real> bias = reference::inverse_dynamics_fully_actuated(free, all, loads).tau;
    const Matrix<Real> H = reference::joint_space_inertia(free, all.q);
    Vector<double> tau(tables.dof());
    for (int k = 0; k < tau.rows(); ++k) tau(k) = reference::uniform(engine, 5.0);
    Vector<Real> missing = Real(-1) * bias;
    for (int k = 0; k < tau.rows(); ++k) missing(k) += static_cast<Real>(tau(k));
    // f follows from the inertia that the rows see; a tiny compliance regularises redundant rows.
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

// Compares with differences of weights times inverse dynamics, which agrees with the reference.
TEST_P(LoopedRobots, HaveTheGradientsOfTheirForces) {
  constexpr Real kStep = 1e-3L, kSame = 1e-9L;
  for (int i = GetParam(); i < looped_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    auto tree = looped_tree(seed);
    if (!tree) continue;
    tree->floating_base = false;
    const InterpretedRobot robot(
        *tree, {}, {}, values_near_defaults(*tree), {}, {"inverse_dynamics", "inverse_dynamics_gradient"});
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
    const std::vector<double> parameters = values_near_defaults(*tree);
    if (!parameters.empty()) inputs["parameters"] = {parameters.begin(), parameters.end()};
    const auto gradient = symbolic::interpret(robot.program("inverse_dynamics_gradient"), inputs);
    for (const char* input : {"q", "qd", "qdd"}) {
      for (std::size_t k = 0; k < inputs.at(input).size(); ++k) {
        const auto weighted = [&](int steps) {
          symbolic::Arrays<Real> moved = inputs;
          moved.at(input)[k] += static_cast<Real>(steps) * kStep;
          moved.erase("weights");
          const auto tau = symbolic::interpret(robot.program("inverse_dynamics"), moved).at("tau");
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

// With its loop forces applied, a tree with all joints free moves in the same way, and the followers need no forces.
TEST_P(LoopedRobots, HaveForcesInTheirLoops) {
  constexpr double kSame = 1e-9;
  for (int i = GetParam(); i < looped_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const auto tree = held(seed);
    if (!tree) continue;
    const InterpretedRobot robot(*tree, {}, {}, values_near_defaults(*tree), {}, {"inverse_dynamics"});
    const reflection::Robot tables = robot.tables();
    if (tree->has_linear_couplings()) continue;  // couplings are further constraints
    std::mt19937_64 engine(seed);
    reference::Sample sample;
    const reference::AtLoops closed = draw(engine, tables, sample);
    const reference::Motion<double>& m = sample.motion;
    const std::vector<double> forces =
        robot.run("loop_forces", {}, {{"q", m.q.values()}, {"qd", m.qd.values()}, {"qdd", m.qdd.values()}})
            .at("forces");

    const reflection::Robot free = reference::with_free_joints(tables);
    reference::Motion<Real> all;
    all.q = reference::joint_positions(closed.robot(), m.q.cast<Real>());
    all.qd = reference::joint_rates(closed.robot(), m.qd.cast<Real>());
    all.qdd = reference::joint_accelerations(closed.robot(), reference::cast<Real>(m));
    reference::Loads<Real> loads = reference::without_passive<Real>({0, 0, -9.81});
    loads.external.assign(static_cast<std::size_t>(tables.links.size), Vector<Real>(6));
    std::size_t next = 0;
    for (int loop = 0; loop < tables.loops.size; ++loop) push(*tree, tables, all.q, loop, forces, next, loads.external);
    EXPECT_EQ(next, forces.size());
    const Vector<Real> tau = reference::inverse_dynamics_fully_actuated(free, all, loads).tau;
    const Vector<double> wanted = robot.inverse_dynamics(m, {});
    const Real size = 1 + reference::largest(tau);
    for (int j = 0; j < tau.rows(); ++j)
      EXPECT_NEAR(static_cast<double>(tau(j)), j < tables.dof() ? wanted(j) : 0.0, kSame * static_cast<double>(size))
          << seed << " " << j << "\n"
          << looped_document(seed);
  }
}

// Checks loop errors where the loops are closed, and where they are open.
TEST_P(LoopedRobots, TellHowTheirLoopsAreOpen) {
  constexpr double kSame = 1e-11;
  for (int i = GetParam(); i < looped_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const auto tree = looped_tree(seed);
    if (!tree) continue;
    const InterpretedRobot robot(
        *tree, {}, i % 2 == 0 ? all_steps() : std::vector<std::string>{}, values_near_defaults(*tree), {},
        {"transforms", "jacobians"});
    const reflection::Robot tables = robot.tables();
    std::mt19937_64 engine(seed);
    reference::Sample sample;
    const reference::AtLoops closed = draw(engine, tables, sample);
    const reference::Motion<double>& m = sample.motion;
    const symbolic::Arrays<double> inputs = {{"q", m.q.values()}, {"qd", m.qd.values()}, {"qdd", m.qdd.values()}};
    const auto expect_all = [&](const std::vector<double>& found, const Vector<Real>& wanted) {
      ASSERT_EQ(static_cast<int>(found.size()), wanted.rows());
      for (int k = 0; k < wanted.rows(); ++k)
        EXPECT_NEAR(
            found[static_cast<std::size_t>(k)], static_cast<double>(wanted(k)),
            1e3 * kSame * (1 + static_cast<double>(reference::largest(wanted))))
            << seed << " " << k;
    };
    expect_all(
        robot.run("joint_velocities", {}, inputs).at("velocities"),
        reference::joint_rates(closed.robot(), m.qd.cast<Real>()));
    expect_all(
        robot.run("joint_accelerations", {}, inputs).at("accelerations"),
        reference::joint_accelerations(closed.robot(), reference::cast<Real>(m)));

    const std::vector<double> positions = robot.run("joint_positions", {}, inputs).at("positions");
    const std::vector<double> none = robot.run("loop_error", {}, {{"positions", positions}}).at("error");
    for (const double e : none) EXPECT_NEAR(e, 0.0, 1e3 * kSame) << seed;

    const Vector<double> open = reference::uniform_vector(engine, tables.joints.size, 2.0);
    const reference::LoopRows rows = reference::loop_rows(tables, open.cast<Real>());
    const std::vector<double> error = robot.run("loop_error", {}, {{"positions", open.values()}}).at("error");
    const std::vector<double> K = robot.run("loop_jacobian", {}, {{"positions", open.values()}}).at("K");
    ASSERT_EQ(K.size(), error.size() * static_cast<std::size_t>(tables.joints.size));
    std::size_t row = 0;
    for (int l = 0; l < tables.loops.size; ++l) {
      const reflection::Loop& loop = tables.loops[l];
      const bool is_distance = loop.type == reflection::LoopType::distance;
      const int count = is_distance ? 1 : loop.type == reflection::LoopType::hinge ? 5 : 3;
      for (int k = 0; k < count; ++k, ++row) {
        // For a distance, the reference has half the difference of the squares.
        const int same = static_cast<int>(rows.error.rows()) / tables.loops.size * l + k;
        const Real length = static_cast<Real>(loop.length);
        const Real apart = is_distance ? std::sqrt(2 * rows.error(same) + length * length) : 1;
        EXPECT_NEAR(error.at(row), static_cast<double>(is_distance ? apart - length : rows.error(same)), kSame * 10)
            << seed;
        for (int c = 0; c < tables.joints.size; ++c)
          EXPECT_NEAR(
              K[static_cast<std::size_t>(c) * error.size() + row], static_cast<double>(rows.columns(same, c) / apart),
              kSame * 10)
              << seed;
      }
    }
    EXPECT_EQ(row, error.size());
  }
}

TEST(LoopedDocuments, NearlyAllClose) {
  int closed = 0;
  for (int i = 0; i < looped_count(); ++i) closed += looped_tree(static_cast<std::uint64_t>(i)) ? 1 : 0;
  EXPECT_GE(closed, looped_count() * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(Shard, LoopedRobots, testing::Range(0, kShards));

}  // namespace
}  // namespace robcogen::numeric::looped_robots_test
