// The programs of robots/whole_body: quadratic programs with nonnegative variables, compared with all subsets of free
// variables; a step of the ground, compared with generated dynamics with contacts; and motions: the robot stands, no
// foot slides, and all of its momentum comes from forces.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

#include "allocation_hook.h"
#include "ground.h"
#include "humanoid.h"
#include "motions.h"
#include "picture.h"
#include "plans.h"
#include "quadruped.h"

namespace whole_body {
namespace {

NonnegativeMatrix random_matrix(std::mt19937_64& engine, int rows, int columns) {
  NonnegativeMatrix m(rows, columns);
  std::uniform_real_distribution<double> number(-1, 1);
  for (Eigen::Index k = 0; k < m.size(); ++k) m.data()[k] = number(engine);
  return m;
}

double cost(const NonnegativeMatrix& Q, const NonnegativeVector& c, const NonnegativeVector& x) {
  return x.dot(0.5 * (Q * x) - c);
}

// The least cost over all subsets of free variables.
double least_cost(const NonnegativeMatrix& Q, const NonnegativeVector& c) {
  const int n = static_cast<int>(c.size());
  double least = 0;
  for (unsigned subset = 1; subset < 1U << n; ++subset) {
    NonnegativeMatrix held = NonnegativeMatrix::Identity(n, n);
    NonnegativeVector right = NonnegativeVector::Zero(n);
    for (int i = 0; i < n; ++i)
      if ((subset >> i & 1U) != 0) {
        right[i] = c[i];
        for (int k = 0; k < n; ++k) held(i, k) = (subset >> k & 1U) != 0 ? Q(i, k) : 0;
      }
    const NonnegativeVector x = held.fullPivLu().solve(right);
    if (x.minCoeff() >= 0) least = std::min(least, cost(Q, c, x));
  }
  return least;
}

TEST(Nonnegative, FindsTheBestOfAllSubsets) {
  std::mt19937_64 engine(7);
  constexpr int kVariables = 7;
  for (int i = 0; i < 200; ++i) {
    // Nearly of low rank, as with friction cones.
    const int rank = 2 + i % 6;
    const NonnegativeMatrix half = random_matrix(engine, rank, kVariables);
    const NonnegativeMatrix Q = half.transpose() * half + 1e-3 * NonnegativeMatrix::Identity(kVariables, kVariables);
    const NonnegativeVector c = random_matrix(engine, kVariables, 1);
    NonnegativeVector x = NonnegativeVector::Zero(kVariables);
    // Starts from any point, such as the optimum of another program.
    if (i % 2 == 0) x = random_matrix(engine, kVariables, 1).cwiseAbs();
    ASSERT_GT(minimise_nonnegative(Q, c, x), 0) << i;
    EXPECT_GE(x.minCoeff(), 0) << i;
    const double best = least_cost(Q, c);
    EXPECT_LT(std::abs(cost(Q, c, x) - best), 1e-9 * (1 + std::abs(best))) << i;
  }
}

// When all feet carry and none slides, a step is forward dynamics with contacts that come to rest within the step.
TEST(Ground, StepIsConstrainedForwardDynamics) {
  using Rows = Sizes<Quadruped>::Rows;
  constexpr double kStep = 2.5e-4;
  constexpr double kNear = 1e-5;  // the iteration ends after some sweeps
  const Quadruped::Robot robot;
  StateOf<Quadruped> state = standing_state<Quadruped>();
  const Stand<Quadruped> plan(state);
  Controller<Quadruped> controller(Settings{});
  Ground<Quadruped> ground(kFriction, kStep);
  for (int i = 0; i < 40; ++i) {
    const auto command = controller(state, plan(i * kStep, state));
    // The ground stops the velocities of points; the generated function takes accelerations.
    const Rows stop = robot.contact_bias(state.q, state.qd, state.base_velocity) -
                      robot.contact_velocity(state.q, state.qd, state.base_velocity) / kStep;
    const auto expected = robot.constrained_forward_dynamics(
        state.q, state.qd, command.tau, state.base_velocity, stop, Eigen::Vector4d::Ones(), Rows::Zero(),
        gravity_in_base(state));
    const StateOf<Quadruped> next = ground(state, command.tau, Vector3d::Zero());
    const Rows wrenches = ContactPoints<Quadruped>(state).map.transpose() * ground.contact().forces;
    const double size = 1 + expected.contact_wrenches.cwiseAbs().maxCoeff();
    EXPECT_LT((wrenches - expected.contact_wrenches).cwiseAbs().maxCoeff(), kNear * size) << i;
    EXPECT_LT(((next.qd - state.qd) / kStep - expected.qdd).cwiseAbs().maxCoeff(), kNear * size) << i;
    state = next;
  }
}

TEST(Controller, ForcesAreInTheirConesAndGiveTheMotion) {
  StateOf<Humanoid> state = standing_state<Humanoid>();
  const Stand<Humanoid> plan(state, 0.2);
  Controller<Humanoid> controller(Settings{});
  state.base_velocity.linear().x() = 0.2;
  const auto command = controller(state, plan(0.5, state));
  EXPECT_TRUE(command.is_best);
  for (int i = 0; i < Sizes<Humanoid>::kPoints; ++i) {
    const Vector3d force = command.forces.segment<3>(3 * i);
    EXPECT_GE(force.z(), Settings{}.least_force / Humanoid::kPointsPerContact);
    EXPECT_LE(force.head<2>().norm(), Settings{}.friction * force.z() + 1e-9);
  }
  // Compare with forward dynamics under these forces on the soles.
  Humanoid::Robot::LinkWrenches external;
  const auto frames = Humanoid::contact_frames(state.q);
  const humanoid_on_soles::Link feet[] = {humanoid_on_soles::Link::left_foot, humanoid_on_soles::Link::right_foot};
  namespace homogeneous = humanoid_on_soles::transforms::homogeneous;
  const Eigen::Matrix4d links[] = {
      homogeneous::fr_pelvis_X_fr_left_foot(state.q), homogeneous::fr_pelvis_X_fr_right_foot(state.q)};
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Vector4d at = frames[c] * Humanoid::contact_points()[k].homogeneous();
      const Vector3d force = state.pose.to_base_axes(command.forces.segment<3>(static_cast<int>(12 * c + 3 * k)));
      const Matrix4d& X = links[c];
      const Vector3d arm = at.head<3>() - X.topRightCorner<3, 1>();
      const Matrix3d link_R_base = X.topLeftCorner<3, 3>().transpose();
      external[feet[c]] = external[feet[c]] + robcogen::Wrench(link_R_base * arm.cross(force), link_R_base * force);
    }
  const auto motion = humanoid_on_soles::forward_dynamics(
      state.q, state.qd, command.tau, state.base_velocity, gravity_in_base(state), external);
  const double size = 1 + command.acceleration.cwiseAbs().maxCoeff();
  EXPECT_LT((motion.qdd - command.acceleration.tail<Humanoid::Robot::kDof>()).cwiseAbs().maxCoeff(), 1e-8 * size);
  EXPECT_LT((motion.base_acceleration.vector() - command.acceleration.head<6>()).cwiseAbs().maxCoeff(), 1e-8 * size);
}

// Real-time control must not allocate.
template <Body B>
void expect_no_allocation() {
  StateOf<B> state = standing_state<B>();
  const Stand<B> plan(state);
  Controller<B> controller(Settings{});
  Ground<B> ground(kFriction, kControlStep);
  {
    const robcogen::NoAllocation during("control and ground");
    for (int i = 0; i < 5; ++i) {
      const auto command = controller(state, plan(i * kControlStep, state));
      state = ground(state, command.tau, Vector3d(10, 0, 0));
    }
  }
  EXPECT_TRUE(state.q.allFinite());
}

TEST(Controller, DoesNotAllocate) {
  expect_no_allocation<Quadruped>();
  expect_no_allocation<Humanoid>();
}

struct Limits {
  double astray, slip;  // m: final distance of the centre of mass from its goal; displacement of the feet
};

void expect_sound(const Motion& motion, const Limits& limits) {
  SCOPED_TRACE(motion.title);
  const Instant& last = motion.instants.back();
  EXPECT_FALSE(motion.has_fallen);
  EXPECT_TRUE(motion.is_solved);
  EXPECT_LT(motion.greatest_missing, 1e-6);
  EXPECT_LT((last.com - last.goal).norm(), limits.astray);
  EXPECT_LT(last.tilt, 0.01);
  EXPECT_LT(motion.greatest_slip, limits.slip);
  EXPECT_LT(motion.greatest_depth, 1e-4);
  EXPECT_LE(motion.greatest_friction, kFriction + 1e-9);
  // Newton's second law for the whole robot: only the ground, gravity and the push change its momentum. Steps are of
  // the first order.
  EXPECT_LT((motion.momentum_given - motion.momentum).norm(), 0.01);
  const std::string text = picture(motion);
  EXPECT_EQ(text.rfind("</svg>\n"), text.size() - 7);
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

double weight_at_end(const Motion& motion) {
  double sum = 0;
  for (const double load : motion.instants.back().loads) sum += load;
  return sum;
}

TEST(WholeBody, QuadrupedStandsUnderAPush) {
  const Motion motion = quadruped_stands({0, 400, 0});
  expect_sound(motion, {2e-3, 1e-3});
  EXPECT_LT(motion.last_speed, 1e-3);
  EXPECT_NEAR(weight_at_end(motion), 9.81 * Quadruped::kMass, 0.5);
  // The push moved the robot, so nothing else holds it.
  double farthest = 0;
  for (const Instant& i : motion.instants)
    if (i.time > motion.push_begins)
      farthest = std::max(farthest, std::abs(i.com.y() - motion.instants.front().com.y()));
  EXPECT_GT(farthest, 0.01);
}

TEST(WholeBody, HumanoidStandsUnderAPush) {
  const Motion motion = humanoid_stands({150, 0, 0});
  expect_sound(motion, {2e-3, 1e-3});
  EXPECT_LT(motion.last_speed, 1e-3);
  EXPECT_NEAR(weight_at_end(motion), 9.81 * Humanoid::kMass, 0.5);
}

// A push that no feet can resist without a step.
TEST(WholeBody, HumanoidFallsUnderAGreatPush) {
  const Motion motion = humanoid_stands({500, 0, 0});
  EXPECT_TRUE(motion.has_fallen);
  const Instant& last = motion.instants.back();
  EXPECT_TRUE(last.com.allFinite());
  EXPECT_GT(last.time, motion.push_begins);
  EXPECT_LT(last.time, 3);
}

TEST(WholeBody, RobotsSquat) {
  for (const Motion& motion : {quadruped_squats(0.15), humanoid_squats(0.2)}) {
    expect_sound(motion, {3e-3, 1e-3});
    double lowest = motion.instants.front().com.z();
    for (const Instant& i : motion.instants) lowest = std::min(lowest, i.com.z());
    EXPECT_NEAR(motion.instants.front().com.z() - lowest, motion.instants.front().loads.size() == 4 ? 0.15 : 0.2, 0.02);
  }
}

TEST(WholeBody, QuadrupedTrotsUnderAPush) {
  const Motion motion = quadruped_trots({0, 300, 0});
  expect_sound(motion, {0.02, 1e-3});
  // Diagonal pairs: some instants on LF and RH, some on RF and LH, and never on one side alone.
  int first = 0, second = 0;
  for (const Instant& i : motion.instants) {
    const auto carries = [&](std::size_t foot) { return i.loads[foot] > 0; };
    first += carries(0) && carries(3) && !carries(1) && !carries(2) ? 1 : 0;
    second += carries(1) && carries(2) && !carries(0) && !carries(3) ? 1 : 0;
    EXPECT_TRUE(carries(0) || carries(2)) << i.time;
    EXPECT_TRUE(carries(1) || carries(3)) << i.time;
  }
  EXPECT_GT(first, 60);
  EXPECT_GT(second, 60);
}

}  // namespace
}  // namespace whole_body
