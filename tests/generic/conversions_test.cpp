// States in the arrays of other libraries. The order of the elements is written out by hand, for a base that is rotated
// by a quarter turn about z: its x axis is the world's y axis, its y axis the world's -x axis.
#include "robcogen/conversions.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "poses.h"

namespace robcogen::test::conversions_test {
namespace {

constexpr double kRounding = 1e-13;  // some rotations of velocities of about ten
constexpr std::array<const char*, 3> kNames = {"hip", "knee", "ankle"};

struct Floating {
  Eigen::Vector3d q = Eigen::Vector3d::Zero(), qd = q;
  BasePose pose;
  Twist base_velocity;
};

struct Fixed {
  Eigen::Vector3f q = Eigen::Vector3f::Zero(), qd = q;
};

JointOrder<3> order_of(const std::vector<std::string>& names) {
  const auto match = match_joints(kNames, names);
  EXPECT_TRUE(match.order) << match.name;
  return *match.order;
}

const std::vector<std::string> kTheirs = {"ankle", "hip", "knee"};
const double kHalf = std::sqrt(0.5);

Floating quarter_turned() {
  Floating state;
  state.q << 0.1, 0.2, 0.3;
  state.qd << 1.1, 1.2, 1.3;
  state.pose = BasePose::from_quaternion_wxyz(kHalf, 0, 0, kHalf, Eigen::Vector3d(7, 8, 9));
  state.base_velocity = Twist(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6));
  return state;
}

// In axes of the world (1, 2, 3) becomes (-2, 1, 3), and (4, 5, 6) becomes (-5, 4, 6).
using Array10 = std::array<double, 10>;
using Array9 = std::array<double, 9>;
const Array10 kMujocoPositions = {7, 8, 9, kHalf, 0, 0, kHalf, 0.3, 0.1, 0.2};
const Array9 kMujocoVelocities = {-5, 4, 6, 1, 2, 3, 1.3, 1.1, 1.2};
const Array10 kPinocchioPositions = {7, 8, 9, 0, 0, kHalf, kHalf, 0.3, 0.1, 0.2};
const Array9 kPinocchioVelocities = {4, 5, 6, 1, 2, 3, 1.3, 1.1, 1.2};
const Array10 kRbdlPositions = {7, 8, 9, 0, 0, kHalf, 0.3, 0.1, 0.2, kHalf};
const Array9 kRbdlVelocities = kMujocoVelocities;
const Array10 kDrakePositions = {kHalf, 0, 0, kHalf, 7, 8, 9, 0.3, 0.1, 0.2};
const Array9 kDrakeVelocities = {-2, 1, 3, -5, 4, 6, 1.3, 1.1, 1.2};

template <std::size_t n>
void expect_near(const std::array<double, n>& a, const std::array<double, n>& b) {
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(a[i], b[i], kRounding) << i;
}

void expect_near(const Floating& a, const Floating& b) {
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.qd, b.qd);
  EXPECT_LT(difference(a.pose, b.pose).vector().norm(), kRounding);
  EXPECT_LT((a.base_velocity - b.base_velocity).vector().norm(), kRounding);
}

template <class To, class From>
void expect_layout(const To& to, const From& from, const Array10& positions, const Array9& velocities) {
  const JointOrder<3> order = order_of(kTheirs);
  Array10 q{};
  Array9 v{};
  to(quarter_turned(), order, q.data(), v.data());
  expect_near(q, positions);
  expect_near(v, velocities);
  expect_near(from(positions.data(), velocities.data(), order), quarter_turned());
}

TEST(Conversions, Mujoco) {
  expect_layout(
      [](const auto&... a) { to_mujoco(a...); }, [](const auto&... a) { return from_mujoco<Floating>(a...); },
      kMujocoPositions, kMujocoVelocities);
}

TEST(Conversions, Pinocchio) {
  expect_layout(
      [](const auto&... a) { to_pinocchio(a...); }, [](const auto&... a) { return from_pinocchio<Floating>(a...); },
      kPinocchioPositions, kPinocchioVelocities);
}

TEST(Conversions, Rbdl) {
  expect_layout(
      [](const auto&... a) { to_rbdl(a...); }, [](const auto&... a) { return from_rbdl<Floating>(a...); },
      kRbdlPositions, kRbdlVelocities);
}

TEST(Conversions, Drake) {
  expect_layout(
      [](const auto&... a) { to_drake(a...); }, [](const auto&... a) { return from_drake<Floating>(a...); },
      kDrakePositions, kDrakeVelocities);
}

TEST(Conversions, Ros) {
  const JointOrder<3> order = order_of(kTheirs);
  Odometry odometry;
  std::array<double, 3> position{}, velocity{};
  to_ros(quarter_turned(), order, odometry, position.data(), velocity.data());
  expect_near(odometry.pose, {7, 8, 9, 0, 0, kHalf, kHalf});
  expect_near(odometry.twist, {4, 5, 6, 1, 2, 3});
  EXPECT_EQ(position, (std::array<double, 3>{0.3, 0.1, 0.2}));
  EXPECT_EQ(velocity, (std::array<double, 3>{1.3, 1.1, 1.2}));
  expect_near(from_ros<Floating>(odometry, position.data(), velocity.data(), order), quarter_turned());
}

// Converts a general orientation from one library through all others.
TEST(Conversions, Chain) {
  std::mt19937_64 engine(21);
  const JointOrder<3> order = order_of(kTheirs);
  for (int i = 0; i < 100; ++i) {
    Floating start = quarter_turned(), state = start;
    start.pose = state.pose = random_pose<double>(engine);
    Array10 q{};
    Array9 v{};
    to_mujoco(state, order, q.data(), v.data());
    state = from_mujoco<Floating>(q.data(), v.data(), order);
    to_drake(state, order, q.data(), v.data());
    state = from_drake<Floating>(q.data(), v.data(), order);
    to_rbdl(state, order, q.data(), v.data());
    state = from_rbdl<Floating>(q.data(), v.data(), order);
    expect_near(state, start);
  }
}

TEST(Conversions, OfAFixedBaseHaveJointsOnly) {
  const JointOrder<3> order = order_of(kTheirs);
  Fixed state;
  state.q << 0.5f, 1.5f, 2.5f;
  state.qd << 3, 4, 5;
  std::array<double, 3> q{}, v{};
  to_rbdl(state, order, q.data(), v.data());
  EXPECT_EQ(q, (std::array<double, 3>{2.5, 0.5, 1.5}));
  EXPECT_EQ(v, (std::array<double, 3>{5, 3, 4}));
  EXPECT_EQ(from_rbdl<Fixed>(q.data(), v.data(), order).q, state.q);
}

// ---- Spherical joints: two, with a knee between them.

constexpr std::array<const char*, 7> kBallNames = {"hip_x", "hip_y", "hip_z", "knee", "ankle_x", "ankle_y", "ankle_z"};
constexpr std::array<int, 2> kQuaternions = {0, 5};
const std::vector<std::string> kTheirBalls = {"ankle", "knee", "hip"};

struct FloatingBalls {
  Eigen::Matrix<double, 9, 1> q = Eigen::Matrix<double, 9, 1>::Zero();
  Eigen::Matrix<double, 7, 1> qd = Eigen::Matrix<double, 7, 1>::Zero();
  BasePose pose;
  Twist base_velocity;
};

FloatingBalls with_balls() {
  FloatingBalls state;
  state.q << 0.1, 0.7, 0.5, 0.5, 2, 0.8, 0, 0.6, 0;
  state.qd << 1, 2, 3, 4, 5, 6, 7;
  const Floating base = quarter_turned();
  state.pose = base.pose;
  state.base_velocity = base.base_velocity;
  return state;
}

using Array16 = std::array<double, 16>;
using Array13 = std::array<double, 13>;

template <class To, class From>
void expect_balls(const To& to, const From& from, const Array16& positions, const Array13& velocities) {
  const auto match = match_joints(kBallNames, kQuaternions, kTheirBalls);
  ASSERT_TRUE(match.order) << match.name;
  Array16 q{};
  Array13 v{};
  to(with_balls(), *match.order, q.data(), v.data());
  expect_near(q, positions);
  expect_near(v, velocities);
  const FloatingBalls back = from(positions.data(), velocities.data(), *match.order);
  EXPECT_LT((back.q - with_balls().q).norm(), kRounding);
  EXPECT_EQ(back.qd, with_balls().qd);
}

TEST(Conversions, OfSphericalJoints) {
  const double h = kHalf;
  expect_balls(
      [](const auto&... a) { to_mujoco(a...); }, [](const auto&... a) { return from_mujoco<FloatingBalls>(a...); },
      {7, 8, 9, h, 0, 0, h, 0.8, 0, 0.6, 0, 2, 0.1, 0.7, 0.5, 0.5}, {-5, 4, 6, 1, 2, 3, 5, 6, 7, 4, 1, 2, 3});
  expect_balls(
      [](const auto&... a) { to_pinocchio(a...); },
      [](const auto&... a) { return from_pinocchio<FloatingBalls>(a...); },
      {7, 8, 9, 0, 0, h, h, 0, 0.6, 0, 0.8, 2, 0.7, 0.5, 0.5, 0.1}, {4, 5, 6, 1, 2, 3, 5, 6, 7, 4, 1, 2, 3});
  expect_balls(
      [](const auto&... a) { to_rbdl(a...); }, [](const auto&... a) { return from_rbdl<FloatingBalls>(a...); },
      {7, 8, 9, 0, 0, h, 0, 0.6, 0, 2, 0.7, 0.5, 0.5, h, 0.8, 0.1}, {-5, 4, 6, 1, 2, 3, 5, 6, 7, 4, 1, 2, 3});
}

TEST(Conversions, MakeQuaternionsOfUnitLength) {
  const auto match = match_joints(kBallNames, kQuaternions, kTheirBalls);
  const Array16 positions = {7, 8, 9, 1, 0, 0, 0, 8, 0, 6, 0, 2, 0.2, 1.4, 1, 1};
  const Array13 velocities{};
  const auto state = from_mujoco<FloatingBalls>(positions.data(), velocities.data(), *match.order);
  EXPECT_LT((state.q - with_balls().q).norm(), kRounding);
}

TEST(JointNames, OfSphericalJointsAreThoseOfTheDocument) {
  const auto problem = [](const std::vector<std::string>& names) {
    return match_joints(kBallNames, kQuaternions, names).problem;
  };
  EXPECT_EQ(problem({"hip", "knee", "ankle"}), JointProblem::none);
  EXPECT_EQ(problem({"hip_x", "knee", "ankle"}), JointProblem::unknown);
  EXPECT_EQ(problem({"hip", "knee"}), JointProblem::missing);
  EXPECT_EQ(problem({"hip", "hip", "knee", "ankle"}), JointProblem::repeated);
  EXPECT_EQ(match_joints(kBallNames, kQuaternions, std::vector<std::string>{"knee", "hip"}).name, "ankle");
}

// ---- Names.

TEST(JointNames, AreMatchedWhateverHoldsThem) {
  const std::array<std::string_view, 3> views = {"knee", "ankle", "hip"};
  const char* const pointers[] = {"knee", "ankle", "hip"};
  for (const auto& match : {match_joints(kNames, views), match_joints(kNames, pointers)}) {
    ASSERT_TRUE(match.order);
    EXPECT_EQ(match.problem, JointProblem::none);
    EXPECT_EQ((*match.order)[0], 2);
    EXPECT_EQ((*match.order)[1], 0);
    EXPECT_EQ((*match.order)[2], 1);
  }
}

TEST(JointNames, ThatDoNotMatchAreRefused) {
  struct Case {
    std::vector<const char*> names;
    JointProblem problem;
    std::string_view name;
  };
  const Case cases[] = {
      {{"ankle", "hip"}, JointProblem::missing, "knee"},
      {{}, JointProblem::missing, "hip"},
      {{"ankle", "hip", "knee", "wheel"}, JointProblem::unknown, "wheel"},
      {{"ankle", "Hip", "knee"}, JointProblem::unknown, "Hip"},
      {{"ankle", nullptr, "knee"}, JointProblem::unknown, ""},
      {{"ankle", "hip", "hip", "knee"}, JointProblem::repeated, "hip"},
  };
  for (const Case& a : cases) {
    const auto match = match_joints(kNames, a.names);
    EXPECT_FALSE(match.order);
    EXPECT_EQ(match.problem, a.problem) << a.name;
    EXPECT_EQ(match.name, a.name);
  }
}

}  // namespace
}  // namespace robcogen::test::conversions_test
