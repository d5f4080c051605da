// Actuators between frames: lengths, lever arms and forces compared with frames and Jacobians of the reference.
#include <gtest/gtest.h>

#include "coupled_robot.h"
#include "interpreted_robot.h"
#include "random_robot.h"
#include "reference_tables.h"
#include "robcogen/reference/samples.h"
#include "volume.h"

namespace robcogen::numeric::actuators_test {
namespace {

using model::KinematicTree;
using reference::Matrix;
using reference::Vector;
using Values = std::vector<double>;

int tree_count() {
  return robot_count() / 20;
}

// Adds actuators between random frames, or one actuator that spans a single joint. Every third robot has coupled
// joints.
KinematicTree with_actuators(std::uint64_t seed) {
  KinematicTree tree = random_robot(seed, {.max_joints = 12});
  if (seed % 3 == 0) tree = coupled(tree, seed).robot;
  std::mt19937_64 engine(seed + 1);
  const std::vector<model::Frame> frames = tree.frames();
  std::uniform_int_distribution<std::size_t> any(0, frames.size() - 1);
  const reference::Tables tables = reference_tables(tree);
  const Vector<double> q = reference::random_sample(engine, tables.robot()).motion.q;
  const bool across_one = seed % 4 == 1;
  for (int k = 0; k < (across_one ? 400 : 12) && tree.actuators.size() < (across_one ? 1 : 4); ++k) {
    const model::Frame &from = frames[any(engine)], &to = frames[any(engine)];
    const Matrix<double> apart =
        reference::transform(tables.robot(), q, frame_index(tree, from), frame_index(tree, to));
    const int joint = tree.links[static_cast<std::size_t>(tree.link_of(to))].parent_joint;
    const bool is_next = joint >= 0 && tree.joints[static_cast<std::size_t>(joint)].parent == tree.link_of(from);
    if (across_one && !is_next) continue;
    // The generator refuses documents whose actuator frames always coincide.
    if (tree.link_of(from) == tree.link_of(to) || reference::largest(reference::origin_of(apart)) < 1e-3) continue;
    tree.actuators.push_back({"actuator_" + std::to_string(k), {from.name, to.name}, {}});
  }
  return tree;
}

struct Expected {
  Values lengths;
  Matrix<double> J;
};

Expected expected(const KinematicTree& tree, const reflection::Robot& tables, const Vector<double>& q) {
  Expected result{{}, Matrix<double>(static_cast<int>(tree.actuators.size()), tables.dof())};
  for (const model::Actuator& actuator : tree.actuators) {
    const int from = frame_index(tree, *tree.find_frame(actuator.frames[0]));
    const int to = frame_index(tree, *tree.find_frame(actuator.frames[1]));
    const Vector<double> apart = reference::origin_of(reference::transform(tables, q, from, to));
    const Matrix<double> velocity = reference::frame_jacobian(tables, q, from, to);
    const double length = std::sqrt(reference::dot(apart, apart));
    for (int c = 0; c < tables.dof(); ++c)
      for (int i = 0; i < 3; ++i)
        result.J(static_cast<int>(result.lengths.size()), c) += apart(i) / length * velocity(3 + i, c);
    result.lengths.push_back(length);
  }
  return result;
}

void expect_near(const Values& found, const Values& wanted, const std::string& what) {
  constexpr double kSame = 1e-11;
  ASSERT_EQ(found.size(), wanted.size()) << what;
  double largest = 1.0;
  for (const double x : wanted) largest = std::max(largest, std::abs(x));
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], wanted[k], kSame * largest) << what << " " << k;
}

TEST(Actuators, AgreeWithTheReference) {
  int with_forces = 0;
  for (int i = 0; i < tree_count(); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const KinematicTree tree = with_actuators(seed);
    if (tree.actuators.empty()) continue;
    const InterpretedRobot robot(
        tree, {}, i % 2 == 0 ? all_steps() : std::vector<std::string>{}, {}, {}, {"transforms", "jacobians"});
    const reflection::Robot tables = robot.tables();
    std::mt19937_64 engine(seed);
    const reference::Motion<double> m = reference::random_sample(engine, tables).motion;
    const Expected wanted = expected(tree, tables, m.q);
    // An actuator whose ends coincide has no direction.
    if (std::any_of(wanted.lengths.begin(), wanted.lengths.end(), [](double l) { return l < 1e-3; })) continue;
    const std::string what = "seed " + std::to_string(seed);
    const auto run = [&](const std::string& function, const std::string& output, const std::string& input, Values v) {
      return robot.run(function, {}, {{"q", m.q.values()}, {input, std::move(v)}}).at(output);
    };
    expect_near(run("actuator_lengths", "lengths", "q", m.q.values()), wanted.lengths, what + " lengths");
    expect_near(
        run("actuator_velocities", "velocities", "qd", m.qd.values()), (wanted.J * m.qd).values(),
        what + " velocities");
    Values by_column;
    for (int c = 0; c < wanted.J.cols(); ++c)
      for (int r = 0; r < wanted.J.rows(); ++r) by_column.push_back(wanted.J(r, c));
    expect_near(run("actuator_jacobian", "J", "q", m.q.values()), by_column, what + " Jacobian");
    const Vector<double> forces = reference::uniform_vector(engine, wanted.J.rows(), 10.0);
    const Values tau = run("actuator_torques", "tau", "forces", forces.values());
    expect_near(tau, (transpose(wanted.J) * forces).values(), what + " torques");
    if (!robot.programs().contains("actuator_forces")) continue;
    ++with_forces;
    expect_near(run("actuator_forces", "forces", "tau", tau), forces.values(), what + " forces");
  }
  EXPECT_GT(with_forces, 0);
}

}  // namespace
}  // namespace robcogen::numeric::actuators_test
