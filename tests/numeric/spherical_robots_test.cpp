// Spherical joints compared with three revolute joints, also at the poles of these.
#include <gtest/gtest.h>

#include "dice.h"
#include "interpreted_robot.h"
#include "random_drives.h"
#include "random_robot.h"
#include "spherical_robot.h"

namespace robcogen::numeric::spherical_robots_test {
namespace {

using model::KinematicTree;
using reference::Arguments;
using reference::Matrix;
using reference::Motion;
using reference::Vector;

constexpr int kRobots = 24;
constexpr double kSame = 1e-10;  // rates of the angles grow as 1 / sin of the middle one, which is at least 0.1

double relative(const Matrix<double>& found, const Matrix<double>& wanted) {
  return reference::largest(found - wanted) / (1 + reference::largest(wanted));
}

// Excludes robots with a spherical joint that moves no inertia about some axis.
KinematicTree robot_of(std::uint64_t seed) {
  for (std::uint64_t next = seed;; next += kRobots) {
    const RobotOptions options = {.min_joints = 2, .max_joints = 8, .odd_documents = seed % 2 == 0};
    KinematicTree robot = with_spherical_joints(random_robot(next, options), next, false);
    if (!robot.inertia_defects.is_singular() && !robot.spherical_joints().empty()) return robot;
  }
}

// Block diagonal: the identity for the base's six coordinates, if it floats, then G.
Matrix<double> with_base(const Matrix<double>& G, bool floating) {
  if (!floating) return G;
  Matrix<double> all(6 + G.rows(), 6 + G.cols());
  all.set_block(0, 0, Matrix<double>::identity(6));
  all.set_block(6, 6, G);
  return all;
}

// Compares both robots in one state.
class BothRobots {
 public:
  BothRobots(const KinematicTree& tree, const EulerRobot& euler, std::uint64_t seed)
      : tree_(tree),
        euler_tree_(euler),
        desired_(desired_of_both(tree, euler, seed)),
        robot_(tree, desired_, seed % 4 == 0 ? all_steps() : std::vector<std::string>{}),
        euler_(euler.robot, desired_of(euler.robot), {}) {}

  // `angles` holds the positions, rates and accelerations of the revolute joints.
  void compare(const Motion<double>& angles, const Vector<double>& gravity) {
    const SphericalState state = spherical_state(tree_, euler_tree_, angles.q, angles.qd, angles.qdd);
    Motion<double> m = angles;
    m.q = state.q;
    m.qd = state.qd;
    m.qdd = state.qdd;
    const bool floating = tree_.floating_base;
    const Matrix<double> G = with_base(state.G, floating);
    const Arguments loads = {&gravity, nullptr};
    const Vector<double> tau = euler_.inverse_dynamics_fully_actuated(angles, loads);
    const double size = 1 + reference::largest(tau);
    EXPECT_LT(reference::largest(transpose(G) * robot_.inverse_dynamics_fully_actuated(m, loads) - tau), kSame * size);
    EXPECT_LT(
        reference::largest(transpose(G) * robot_.bias_forces(m, loads) - euler_bias(m, angles, G, loads)),
        kSame * size);
    EXPECT_LT(
        relative(transpose(G) * robot_.gravity_forces(m.q, loads), euler_.gravity_forces(angles.q, loads)), kSame);
    const Matrix<double> H = robot_.joint_space_inertia(m.q);
    EXPECT_LT(relative(transpose(G) * H * G, euler_.joint_space_inertia(angles.q)), kSame);
    EXPECT_NEAR(robot_.kinetic_energy(m), euler_.kinetic_energy(angles), kSame * (1 + euler_.kinetic_energy(angles)));
    EXPECT_NEAR(robot_.potential_energy(m.q, loads), euler_.potential_energy(angles.q, loads), kSame * size);
    EXPECT_LT(relative(robot_.center_of_mass_jacobian(m.q) * G, euler_.center_of_mass_jacobian(angles.q)), kSame);
    EXPECT_LT(relative(robot_.centroidal_momentum_matrix(m.q) * G, euler_.centroidal_momentum_matrix(angles.q)), kSame);
    compare_coriolis(m);
    compare_accelerations(m, loads);
    compare_frames(m, angles, state.G);
  }

 private:
  const KinematicTree& tree_;
  const EulerRobot& euler_tree_;
  model::DesiredTransforms desired_;
  InterpretedRobot robot_, euler_;

  // A spherical joint shares its frame with the first revolute joint, unless that one has a rotation in front.
  static model::DesiredTransforms desired_of_both(
      const KinematicTree& tree,
      const EulerRobot& euler,
      std::uint64_t seed) {
    model::DesiredTransforms desired = random_desired(seed, tree);
    const auto is_other = [&](const model::Frame& frame) {
      return frame.kind == model::Frame::Kind::joint && euler.other && !euler.robot.find_frame(frame.name);
    };
    for (auto* list : {&desired.transforms, &desired.jacobians})
      std::erase_if(*list, [&](const model::FramePair& pair) { return is_other(pair.left) || is_other(pair.right); });
    return desired;
  }

  model::DesiredTransforms desired_of(const KinematicTree& other) const {
    model::DesiredTransforms result = desired_;
    for (auto* list : {&result.transforms, &result.jacobians})
      for (model::FramePair& pair : *list)
        pair = {*other.find_frame(tail(other, pair.left)), *other.find_frame(tail(other, pair.right))};
    return result;
  }
  static std::string tail(const KinematicTree& other, const model::Frame& frame) {
    return other.find_frame(frame.name) ? frame.name : frame.name + "_x";
  }

  // Bias forces of the revolute joints: their accelerations are not zero when those of the spherical joints are.
  Vector<double> euler_bias(
      const Motion<double>& m,
      const Motion<double>& angles,
      const Matrix<double>& G,
      const Arguments& loads) const {
    Motion<double> steady = angles;
    const int first = tree_.floating_base ? 6 : 0, n = tree_.dof();
    const Matrix<double> own = G.block(first, first, n, n);
    steady.qdd = angles.qdd - reference::solve(own, m.qdd);
    steady.base_acceleration = Vector<double>(6);
    return euler_.inverse_dynamics_fully_actuated(steady, loads);
  }

  void compare_coriolis(const Motion<double>& m) const {
    const Vector<double> velocity = tree_.floating_base ? reference::stacked(m.base_velocity, m.qd) : m.qd;
    EXPECT_LT(relative(robot_.coriolis_matrix(m) * velocity, robot_.coriolis_forces(m)), kSame);
  }

  // Forward dynamics inverts inverse dynamics, and the factor solves systems with H.
  void compare_accelerations(const Motion<double>& m, const Arguments& loads) const {
    const int n = tree_.dof();
    const Vector<double> tau = robot_.inverse_dynamics(m, loads).tail(n);
    EXPECT_LT(relative(robot_.forward_dynamics(m, tau, loads).tail(n), m.qdd), 1e-8);
    const Matrix<double> H = robot_.joint_space_inertia(m.q);
    const Vector<double> x = H * (tree_.floating_base ? reference::stacked(m.base_velocity, m.qd) : m.qd);
    EXPECT_LT(relative(H * robot_.inertia_factor(m.q, x).solution, x), 1e-9);
  }

  void compare_frames(const Motion<double>& m, const Motion<double>& angles, const Matrix<double>& G) const {
    const reflection::Robot ours = robot_.tables(), theirs = euler_.tables();
    for (int i = 0; i < ours.transforms.size; ++i) {
      const reference::TransformForms a = robot_.transform(i, m.q), b = euler_.transform(i, angles.q);
      EXPECT_LT(relative(a.homogeneous, b.homogeneous), kSame);
      EXPECT_LT(relative(a.motion, b.motion), kSame);
      EXPECT_LT(relative(a.force, b.force), kSame);
    }
    for (int i = 0; i < ours.jacobians.size; ++i) {
      const Matrix<double> own = part_of(G, ours.jacobians[i], theirs.jacobians[i]);
      EXPECT_LT(relative(robot_.jacobian(i, m.q) * own, euler_.jacobian(i, angles.q)), kSame) << ours.jacobians[i].name;
    }
  }

  // The part of G for the coordinates of a chain in both robots.
  static Matrix<double> part_of(const Matrix<double>& G, const reflection::Jacobian& a, const reflection::Jacobian& b) {
    Matrix<double> part(a.column_count, b.column_count);
    for (int r = 0; r < part.rows(); ++r)
      for (int c = 0; c < part.cols(); ++c) part(r, c) = G(a.columns[r], b.columns[c]);
    return part;
  }
};

Motion<double> random_motion(const KinematicTree& robot, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const int n = robot.dof();
  Motion<double> m;
  m.q = reference::uniform_vector(engine, n, 1);
  m.qd = reference::uniform_vector(engine, n, 2);
  m.qdd = reference::uniform_vector(engine, n, 5);
  if (robot.floating_base) {
    m.base_velocity = reference::uniform_vector(engine, 6, 2);
    m.base_acceleration = reference::uniform_vector(engine, 6, 5);
  }
  return m;
}

// Moves the angles at least kLeast, in rad, away from the pole.
void leave_pole(const KinematicTree& robot, Vector<double>& angles) {
  constexpr double kLeast = 0.1;
  for (const int first : robot.spherical_joints()) {
    double& middle = angles(first + 1);
    middle += middle < 0 ? -kLeast : kLeast;
  }
}

class SphericalRobots : public testing::TestWithParam<int> {};

TEST_P(SphericalRobots, AreAsThreeRevoluteJoints) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  const KinematicTree robot = robot_of(seed);
  const EulerRobot euler = with_euler_angles(robot);
  Motion<double> m = random_motion(robot, seed);
  leave_pole(robot, m.q);
  BothRobots(robot, euler, seed).compare(m, {1.0, -2.0, -9.0});
  if (HasFailure()) std::cout << "seed " << seed << "\n" << describe(robot);
}

// Compares with textbook dynamics, which uses poses as matrices, and checks identities.
TEST_P(SphericalRobots, AgreeWithTheReferenceAndWithThemselves) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  const RobotOptions options = {.min_joints = 2, .max_joints = 8, .odd_documents = seed % 2 == 0};
  for (std::uint64_t next = seed;; next += kRobots) {
    const KinematicTree robot = with_spherical_joints(with_random_drives(random_robot(next, options), next), next);
    if (robot.inertia_defects.is_singular() || robot.spherical_joints().empty()) continue;
    const std::vector<std::string> passes = seed % 4 == 0 ? pass::names() : std::vector<std::string>{};
    const auto checks = check_all(InterpretedRobot(robot, random_desired(seed, robot), passes), seed, 5);
    EXPECT_EQ(checks.failures(), 0) << "seed " << next << "\n" << checks.failure_report() << describe(robot);
    return;
  }
}

// Where one choice of angles has its pole, the other one has none.
TEST_P(SphericalRobots, PassThroughThePolesOfRevoluteJoints) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  const KinematicTree robot = robot_of(seed);
  const EulerRobot euler = with_euler_angles(robot), other = with_euler_angles(robot, true);
  Motion<double> m = random_motion(robot, seed + 1000);
  for (const int first : robot.spherical_joints()) m.q(first + 1) = 0;
  m.q = other_angles(robot, euler, m.q);
  BothRobots(robot, other, seed).compare(m, {0.5, 2.0, -9.81});
  if (HasFailure()) std::cout << "seed " << seed << "\n" << describe(robot);
}

INSTANTIATE_TEST_SUITE_P(Seed, SphericalRobots, testing::Range(0, kRobots));

}  // namespace
}  // namespace robcogen::numeric::spherical_robots_test
