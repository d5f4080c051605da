// The quadruped on its feet at random states, for programs that compare its forward dynamics with other libraries.
#pragma once

#include <quadruped_on_feet/quadruped_on_feet.h>
#include <robcogen/conversions.h>
#include <robcogen/generic/simulation.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <string>
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

// The least of several averages over the states (ns).
template <class Run>
double time_of(const std::vector<Call>& calls, const Run& run) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRounds = 300, kTimes = 2;  // short rounds, which other programs seldom interrupt
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

// Whether a peer computes the same accelerations on these feet. On four feet, also prints the time of a call of both.
template <class Comparison>
bool compare_on(const Active& active, const std::string& urdf, const char* peer, std::mt19937_64& engine) {
  Comparison comparison(urdf, active);
  std::vector<Call> calls;
  double most = 0;
  for (int i = 0; i < kStates; ++i) {
    calls.push_back(comparison.call(engine));
    most = std::max(most, comparison.difference(calls.back()));
  }
  std::printf("%g feet: accelerations differ by %.1e of the largest\n", active.sum(), most);
  if (!(most < kAgreement)) return false;
  if (active.sum() != 4) return true;
  comparison.prepare_timing();
  double sum = 0;
  const double ours = time_of(calls, [&](const Call& c) { sum += run_generated(c, active).qdd[0]; });
  const double theirs = time_of(calls, [&](const Call& c) { comparison.run_theirs(c); });
  std::printf("generated: %.0f ns, %s: %.0f ns a call%s\n", ours, peer, theirs, std::isnan(sum) ? " (NaN)" : "");
  return true;
}

// The main function of a program that compares with a peer, on each of these sets of feet. Returns its exit status.
template <class Comparison>
int compare(const std::string& program, const char* peer, const std::vector<Active>& feet, int argc, char** argv) {
  const auto fail = [&](const char* message) { std::fprintf(stderr, "%s: %s\n", program.c_str(), message); };
  try {
    if (argc != 2) {
      std::fprintf(stderr, "usage: %s <URDF>\n", program.c_str());
      return 2;
    }
    std::mt19937_64 engine(3);
    bool is_equal = true;
    for (const Active& active : feet) is_equal = compare_on<Comparison>(active, argv[1], peer, engine) && is_equal;
    if (!is_equal) fail("results differ");
    return is_equal ? 0 : 1;
  } catch (const std::exception& e) {
    fail(e.what());
  }
  return 2;
}

}  // namespace robcogen::bench
