// Positions with quaternions: integration and its inverse, simulation, control, and AnyRobot for a robot with ball
// joints.
#include "robcogen/positions.h"

#include <ball_leg/ball_leg.h>
#include <ball_leg/reflection.h>
#include <gtest/gtest.h>
#include <hyl/hyl.h>

#include "robcogen/any_robot.h"
#include "robcogen/generic/computed_torque.h"
#include "robcogen/generic/simulation.h"
#include "robcogen/reference/samples.h"

namespace robcogen::test {
namespace {

using R = ball_leg::Robot;
using Way = R::JointState;
using Q = JointPositions<R>;

static_assert(FixedBaseRobot<R> && HasEnergy<R> && HasCentroidal<R>);
static_assert(R::kDof == 7 && R::kPositions == 9 && kPositionCount<R> == 9);
static_assert(kQuaternions<R>.size() == 2 && kQuaternions<R>[0] == 0 && kQuaternions<R>[1] == 5);
static_assert(ball_leg::index(ball_leg::Position::knee) == 4 && ball_leg::index(ball_leg::Joint::knee) == 3);
static_assert(std::is_same_v<JointPositions<hyl::Robot>, hyl::JointState>);

// A robot with a loop that is assembled away from zero: three coordinates, and one follower.
struct Assembled {
  using Scalar = double;
  using JointState = Eigen::Vector3d;
  using JointPositions = Eigen::Vector4d;
  static constexpr std::array<int, 0> kQuaternions = {};
  static constexpr std::array<double, 1> kAssembledFollowers = {0.7};
  static constexpr std::array<double, 3> kAssembledCoordinates = {0.3, 0.0, -0.5};
};

// The same with a spherical joint.
struct AssembledWithBall {
  using Scalar = double;
  using JointState = Eigen::Vector4d;
  using JointPositions = Eigen::Matrix<double, 6, 1>;
  static constexpr std::array<int, 1> kQuaternions = {1};
  static constexpr std::array<double, 1> kAssembledFollowers = {0.7};
};

Way random_way(std::mt19937_64& engine, double limit) {
  Way way;
  for (double& x : way) x = reference::uniform(engine, limit);
  return way;
}

Q random_positions(std::mt19937_64& engine) {
  return integrate_positions<R>(neutral_positions<R>(), random_way(engine, 1.5), 1.0);
}

TEST(Positions, OfCoordinatesMoveAndFollowersStay) {
  using B = AssembledWithBall;
  const JointPositions<B> next = move_coordinates<B>(neutral_positions<B>(), B::JointState(0.4, 0.0, 2.0, 0.0), 0.5);
  JointPositions<B> expected;
  expected << 0.2, std::cos(0.5), 0.0, std::sin(0.5), 0.0, 0.7;
  EXPECT_LT((next - expected).norm(), 1e-15);
}

TEST(Positions, WaysLeadFromOneToTheOther) {
  std::mt19937_64 engine(1);
  for (const double limit : {1e-12, 1e-5, 1e-3, 0.1, 1.7}) {
    for (int i = 0; i < 50; ++i) {
      const Q from = random_positions(engine);
      const Way way = random_way(engine, limit);
      const Q to = integrate_positions<R>(from, way / 0.25, 0.25);
      for (const int k : kQuaternions<R>) EXPECT_NEAR(to.segment<4>(k).norm(), 1.0, 1e-15);
      const double scale = 1e-15 + 1e-14 * limit;
      EXPECT_LT((position_difference<R>(from, to) - way).norm(), 40 * (scale + 1e-16)) << limit;
      // A quaternion of the other sign is the same orientation.
      Q other = to;
      other.segment<4>(5) *= -1;
      EXPECT_LT((position_difference<R>(from, other) - way).norm(), 40 * (scale + 1e-16)) << limit;
    }
  }
}

// Compares the generated functions, which other languages have, with the header: also where nothing moves, and close to
// half a turn.
TEST(Positions, GeneratedFunctionsMoveThemAlike) {
  std::mt19937_64 engine(7);
  for (const double limit : {0.0, 1e-17, 1e-9, 1e-3, 1.0, 1.8}) {
    for (int i = 0; i < 50; ++i) {
      const Q from = random_positions(engine);
      const Way way = random_way(engine, limit);
      const Q to = integrate_positions<R>(from, way, 1.0);
      EXPECT_LT((ball_leg::integrate_positions(from, way) - to).cwiseAbs().maxCoeff(), 1e-15);
      EXPECT_LT((ball_leg::position_difference(from, to) - way).norm(), 1e-14 + 1e-13 * limit) << limit;
      EXPECT_LT((ball_leg::position_difference(from, to) - position_difference<R>(from, to)).norm(), 1e-13);
      Q other = to;
      other.segment<4>(0) *= -1;
      EXPECT_LT((ball_leg::position_difference(from, other) - way).norm(), 1e-14 + 1e-13 * limit) << limit;
    }
  }
}

// Compares with rotation matrices: the child turns about its own axes, exp([w]x).
TEST(Positions, TurnsAreThoseOfTheChild) {
  std::mt19937_64 engine(2);
  for (int i = 0; i < 50; ++i) {
    const Q from = random_positions(engine);
    const Way way = random_way(engine, 2.0);
    const Q to = integrate_positions<R>(from, way, 1.0);
    const Eigen::Vector3d turn = way.head<3>();
    const Eigen::Matrix3d expected = Eigen::Quaterniond(from[0], from[1], from[2], from[3]).toRotationMatrix() *
                                     Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    const Eigen::Matrix3d found = Eigen::Quaterniond(to[0], to[1], to[2], to[3]).toRotationMatrix();
    EXPECT_LT((found - expected).norm(), 1e-14);
    EXPECT_NEAR(to[4], from[4] + way[3], 1e-15);
  }
}

// Compares the velocity of the toe with its rate along integrated positions.
TEST(Positions, RatesAreThoseOfFrames) {
  std::mt19937_64 engine(3);
  for (int i = 0; i < 20; ++i) {
    const Q q = random_positions(engine);
    const Way qd = random_way(engine, 2.0);
    const auto toe = [&](double t) {
      const Q there = integrate_positions<R>(q, qd, t);
      return Eigen::Vector3d(ball_leg::transforms::homogeneous::fr_trunk_X_toe(there).topRightCorner<3, 1>());
    };
    const double h = 1e-3;
    const Eigen::Vector3d rate = (8 * (toe(h) - toe(-h)) - (toe(2 * h) - toe(-2 * h))) / (12 * h);
    const Eigen::Vector3d found = (ball_leg::jacobians::fr_trunk_J_toe(q) * qd).tail<3>();
    EXPECT_LT((found - rate).norm(), 1e-9);
  }
}

TEST(Positions, OfOtherRobotsAreAdded) {
  hyl::JointState q, qd;
  q << 0.1, -0.2, 0.3;
  qd << 1, 2, 3;
  EXPECT_EQ(integrate_positions<hyl::Robot>(q, qd, 0.5), hyl::JointState(q + 0.5 * qd));
  EXPECT_EQ(position_difference<hyl::Robot>(q, qd), hyl::JointState(qd - q));
  EXPECT_EQ(neutral_positions<hyl::Robot>(), hyl::JointState::Zero());
  EXPECT_EQ(neutral_positions<Assembled>(), (Eigen::Vector4d(0.3, 0.0, -0.5, 0.7)));
}

State<R> moving_state() {
  std::mt19937_64 engine(4);
  State<R> state;
  state.q = random_positions(engine);
  state.qd = random_way(engine, 2.0);
  return state;
}

// Joint forces that compensate damping.
Way undamped(const State<R>& s) {
  Way tau;
  for (int j = 0; j < R::kDof; ++j) tau[j] = R::kJointDrives[static_cast<std::size_t>(j)].damping * s.qd[j];
  return tau;
}

double energy_after(double duration, int steps) {
  State<R> s = moving_state();
  for (int i = 0; i < steps; ++i)
    s = runge_kutta_step(s, duration / steps, [](const State<R>& at) { return acceleration(R(), at, undamped(at)); });
  for (const int k : kQuaternions<R>) EXPECT_NEAR(s.q.segment<4>(k).norm(), 1.0, 1e-14);
  return R::kinetic_energy(s.q, s.qd) + R::potential_energy(s.q);
}

TEST(Positions, FreeMotionKeepsEnergy) {
  const State<R> s = moving_state();
  const double energy = R::kinetic_energy(s.q, s.qd) + R::potential_energy(s.q);
  const double coarse = std::abs(energy_after(1.0, 500) - energy), fine = std::abs(energy_after(1.0, 1000) - energy);
  EXPECT_LT(fine, 1e-6 * std::abs(energy));
  EXPECT_GT(coarse / fine, 12);  // fourth order, or better
}

TEST(Positions, SemiImplicitEulerConverges) {
  const auto end = [](int steps) {
    State<R> s = moving_state();
    for (int i = 0; i < steps; ++i)
      s = semi_implicit_euler_step(
          s, 0.2 / steps, [](const State<R>& at) { return acceleration(R(), at, undamped(at)); });
    return s.q;
  };
  const Q best = end(16000);
  const double coarse = position_difference<R>(end(500), best).norm();
  const double fine = position_difference<R>(end(1000), best).norm();
  EXPECT_NEAR(coarse / fine, 2.0, 0.2);
}

// The errors of all joints decay, including those of orientations.
TEST(Positions, ComputedTorqueFollowsOrientations) {
  State<R> s = moving_state();
  Setpoint<R> wanted;
  wanted.q = neutral_positions<R>();
  const Gains<R> gains = critically_damped<R>(8);
  for (int i = 0; i < 3000; ++i)
    s = semi_implicit_euler_step(
        s, 1e-3, [&](const State<R>& at) { return acceleration(R(), at, computed_torque(R(), at, wanted, gains)); });
  EXPECT_LT(position_difference<R>(s.q, wanted.q).norm(), 1e-6);
}

TEST(Positions, AnyRobotKnowsBothSizes) {
  const AnyRobot any = make_any<R>(ball_leg::reflection::robot);
  EXPECT_EQ(any.dof(), 7);
  EXPECT_EQ(any.position_count(), 9);
  const State<R> s = moving_state();
  Eigen::VectorXd q = s.q, v = s.qd, qdd = Eigen::VectorXd::Ones(7), tau(7);
  any.inverse_dynamics(q, v, qdd, tau);
  EXPECT_EQ(tau, Eigen::VectorXd(R::inverse_dynamics(s.q, s.qd, Way::Ones(), kStandardGravity)));
  try {
    any.inverse_dynamics(v, v, qdd, tau);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "inverse_dynamics of ball_leg: q has 7 elements and must have 9");
  }
}

}  // namespace
}  // namespace robcogen::test
