// The quadruped on its feet at random states, for programs that compare its forward dynamics with other libraries.
#pragma once

#include <quadruped_on_feet/quadruped_on_feet.h>
#include <robcogen/conversions.h>
#include <robcogen/generic/simulation.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

namespace robcogen::bench {

namespace quadruped = quadruped_on_feet;
using Robot = quadruped::Robot;
using State = robcogen::State<Robot>;
using Rows = Eigen::Matrix<double, 12, 1>;
using Active = Eigen::Vector4d;

inline constexpr double kAgreement = 1e-10;  // of the largest acceleration
inline constexpr int kStates = 50;
inline constexpr int kDof = quadruped::kDof;

struct Call {
  State state;
  quadruped::JointState tau;
  Rows contact_acceleration = Rows::Zero(), compliance = Rows::Zero();
};

inline Call random_call(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> number(-1, 1);
  Call c;
  for (double& x : c.state.q) x = number(engine);
  for (double& x : c.state.qd) x = number(engine);
  for (double& x : c.tau) x = 20 * number(engine);
  c.state.pose = BasePose::from_rpy(number(engine), number(engine), number(engine), Eigen::Vector3d(0, 0, 0.6));
  Eigen::Matrix<double, 6, 1> velocity;
  for (double& x : velocity) x = number(engine);
  c.state.base_velocity = Twist(velocity);
  return c;
}

inline quadruped::ConstrainedForwardDynamics run_generated(const Call& c, const Active& active) {
  return quadruped::constrained_forward_dynamics(
      c.state.q, c.state.qd, c.tau, c.state.base_velocity, c.contact_acceleration, active, c.compliance,
      gravity_in_base(c.state));
}

// The least of some averages over the states (ns).
template <class Run>
double time_of(const std::vector<Call>& calls, const Run& run) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRounds = 300, kTimes = 2;  // short ones, which other programs seldom interrupt
  double least = HUGE_VAL;
  for (int round = 0; round < kRounds; ++round) {
    const auto before = Clock::now();
    for (int i = 0; i < kTimes; ++i)
      for (const Call& c : calls) run(c);
    const std::chrono::duration<double, std::nano> time = Clock::now() - before;
    least = std::min(least, time.count() / kTimes / static_cast<double>(calls.size()));
  }
  return least;
}

}  // namespace robcogen::bench
