// Robots with coupled joints: all functions compared with the reference, whose bodies move by the couplings, and with
// the Lagrange reduction of the robot whose joints are free.
#include <gtest/gtest.h>

#include "coupled_robot.h"
#include "interpreted_robot.h"
#include "random_drives.h"
#include "random_robot.h"
#include "reference_tables.h"
#include "volume.h"

namespace robcogen::numeric::coupled_robots_test {
namespace {

using model::KinematicTree;
using reference::Arguments;
using reference::Matrix;
using reference::Motion;
using reference::Vector;

constexpr int kShards = 10;

int coupled_count() {
  return robot_count() / 4;
}

std::vector<std::string> steps(std::uint64_t seed) {
  return seed % 4 == 0 ? all_steps() : std::vector<std::string>{};
}

class CoupledRobots : public testing::TestWithParam<int> {};

TEST_P(CoupledRobots, AgreeWithTheReferenceAndWithThemselves) {
  for (int i = GetParam(); i < coupled_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const bool parametric = i % 5 == 0;
    KinematicTree free = random_robot(seed, {.min_joints = 2, .max_joints = 25});
    if (i % 3 == 0) free = with_random_drives(std::move(free), seed);
    const CoupledRobot made = coupled(free, seed, parametric);
    const InterpretedRobot robot(made.robot, random_desired(seed, made.robot), steps(seed), made.parameters);
    const reference::Checks checks = check_all(robot, seed, state_count());
    EXPECT_EQ(checks.failures(), 0) << "seed " << seed << ", " << made.robot.dof() << " coordinates\n"
                                    << checks.failure_report() << describe(made.robot);
    if (HasFailure()) return;
  }
}

// q = G y + c, with rows in the order of the free robot's joints.
struct Reduction {
  explicit Reduction(const KinematicTree& robot)
      : G(static_cast<int>(robot.joints.size()), robot.dof()), c(static_cast<int>(robot.joints.size())) {
    const std::vector<int> independent = robot.coordinates();
    const auto column = [&](int joint) {
      return static_cast<int>(std::find(independent.begin(), independent.end(), joint) - independent.begin());
    };
    for (const int joint : independent) G(joint, column(joint)) = 1;
    for (const model::Coupling& coupling : robot.couplings) {
      for (const model::Coupling::Term& term : coupling.terms)
        G(coupling.joint, column(term.joint)) = model::evaluate(term.factor);
      c(coupling.joint) = model::evaluate(coupling.offset);
    }
  }

  Motion<double> free(const Motion<double>& m) const {
    Motion<double> result = m;
    result.q = G * m.q + c;
    result.qd = G * m.qd;
    result.qdd = G * m.qdd;
    return result;
  }
  // G with the six base coordinates in front, if the base floats.
  Matrix<double> with_base(bool floating) const {
    if (!floating) return G;
    Matrix<double> all(6 + G.rows(), 6 + G.cols());
    all.set_block(0, 0, Matrix<double>::identity(6));
    all.set_block(6, 6, G);
    return all;
  }

  Matrix<double> G;
  Vector<double> c;
};

double relative(const Matrix<double>& found, const Matrix<double>& wanted) {
  return reference::largest(found - wanted) / (1 + reference::largest(wanted));
}

TEST_P(CoupledRobots, AreTheReductionOfFreeOnes) {
  constexpr double kSame = 1e-11;
  for (int i = GetParam(); i < coupled_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const KinematicTree tree = random_robot(seed, {.min_joints = 2, .max_joints = 16});
    const KinematicTree tied = coupled(tree, seed).robot;
    const InterpretedRobot robot(tied, {}, {});
    const reference::Tables free = reference_tables(tree);
    std::mt19937_64 engine(seed);
    const Motion<double> m = reference::random_sample(engine, robot.tables()).motion;
    const Reduction reduction(tied);
    const Matrix<double> G = reduction.with_base(tree.floating_base);
    const Motion<double> moved = reduction.free(m);

    const Matrix<double> H = reference::joint_space_inertia(free.robot(), moved.q);
    EXPECT_LT(relative(robot.joint_space_inertia(m.q), transpose(G) * H * G), kSame) << seed;

    const reference::Loads<double> loads = reference::loads<double>({0, 0, -9.81});
    const reference::Forces<double> forces = reference::inverse_dynamics_fully_actuated(free.robot(), moved, loads);
    const Vector<double> all = tree.floating_base ? reference::stacked(forces.base_wrench, forces.tau) : forces.tau;
    EXPECT_LT(relative(robot.inverse_dynamics_fully_actuated(m, {}), transpose(G) * all), kSame) << seed;

    if (tied.couplings.empty()) continue;
    const auto outputs = robot.run("joint_positions", {}, {{"q", m.q.values()}}).at("positions");
    std::vector<int> order = tied.coordinates();
    for (const model::Coupling& coupling : tied.couplings) order.push_back(coupling.joint);
    for (std::size_t k = 0; k < order.size(); ++k) EXPECT_NEAR(outputs[k], moved.q(order[k]), 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Shard, CoupledRobots, testing::Range(0, kShards));

}  // namespace
}  // namespace robcogen::numeric::coupled_robots_test
