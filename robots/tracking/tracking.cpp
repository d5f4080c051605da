#include "tracking.h"

#include <hyl/hyl.h>

#include <Eigen/LU>
#include <chrono>
#include <cmath>

#include "robcogen/generic/computed_torque.h"
#include "robcogen/generic/simulation.h"

namespace tracking {
namespace {

using hyl::JointState;
using Robot = hyl::Robot;
using State = robcogen::State<Robot>;
using Setpoint = robcogen::Setpoint<Robot>;
using Eigen::Vector2d;

// SLIDE (m), HFE and KFE (rad): the foot is below the hip, and swings back and forth while the knee bends.
const JointState kCentre(0.64, -0.65, 1.34);
const JointState kAmplitude(0, 0.3, 0.4);

constexpr double kFriction = 0.1;      // N m s/rad, in hip and knee
constexpr double kActuatorLag = 1e-3;  // s, after which 37 % of a change of force remains
constexpr double kPlantRate = 4000;    // Hz
constexpr double kSettled = 0.2;       // s: exp(-kPole kSettled) is 3e-4

Setpoint wanted_at(double time) {
  const double w = 2 * M_PI * kFrequency;
  Setpoint wanted;
  wanted.q = kCentre + kAmplitude * std::sin(w * time);
  wanted.qd = w * kAmplitude * std::cos(w * time);
  wanted.qdd = -w * w * kAmplitude * std::sin(w * time);
  return wanted;
}

// Force on each joint; the force on SLIDE acts on its support. Without a model, `inertia` is the inertia at each joint.
JointState control(Law law, const JointState& inertia, const State& state, const Setpoint& wanted) {
  const robcogen::Gains<Robot> gains = robcogen::critically_damped<Robot>(kPole);
  if (law == Law::inverse_dynamics) return robcogen::computed_torque(Robot(), state, wanted, gains);
  return inertia.cwiseProduct(
      gains.stiffness.cwiseProduct(wanted.q - state.q) + gains.damping.cwiseProduct(wanted.qd - state.qd));
}

// Accelerations with the slider held: H qdd + bias = tau for the joints of the leg only.
JointState held_acceleration(const State& state, const Vector2d& tau) {
  const Eigen::Matrix2d H = hyl::joint_space_inertia(state.q).bottomRightCorner<2, 2>();
  const Vector2d bias = hyl::bias_forces(state.q, state.qd).tail<2>();
  const Vector2d friction = kFriction * state.qd.tail<2>();
  JointState qdd = JointState::Zero();
  qdd.tail<2>() = H.inverse() * (tau - friction - bias);
  return qdd;
}

void add_errors(Result& run) {
  run.rms.setZero();
  run.largest.setZero();
  int count = 0;
  for (const Instant& instant : run.instants) {
    if (instant.time < kSettled) continue;
    const Vector2d error = (instant.found - instant.wanted).cwiseAbs();
    run.rms += error.cwiseAbs2();
    run.largest = run.largest.cwiseMax(error);
    ++count;
  }
  if (count > 0) run.rms = (run.rms / count).cwiseSqrt();
}

}  // namespace

Result run(Law law, double rate, double duration) {
  using Clock = std::chrono::steady_clock;
  const int steps = static_cast<int>(std::lround(duration * kPlantRate));
  const int steps_per_cycle = static_cast<int>(std::lround(kPlantRate / rate));
  const int steps_per_instant = static_cast<int>(std::lround(kPlantRate / 1000));
  const double step = 1 / kPlantRate, arrived = 1 - std::exp(-step / kActuatorLag);

  const JointState inertia = hyl::joint_space_inertia(kCentre).diagonal();
  Result result{law, rate, {}, {}, {}, {}};
  State state{wanted_at(0).q, wanted_at(0).qd};
  Vector2d commanded = control(Law::inverse_dynamics, inertia, state, wanted_at(0)).tail<2>(), tau = commanded;
  for (int i = 0; i <= steps; ++i) {
    const double time = i * step;
    const Setpoint wanted = wanted_at(time);
    if (i % steps_per_instant == 0) result.instants.push_back({time, wanted.q.tail<2>(), state.q.tail<2>()});
    // The controller measures, computes, and holds its command until the next cycle.
    if (i % steps_per_cycle == 0) {
      const Clock::time_point before = Clock::now();
      commanded = control(law, inertia, state, wanted).tail<2>();
      const Clock::time_point after = Clock::now();
      result.loop_times.push_back(std::chrono::duration<double, std::nano>(after - before).count());
    }
    tau += arrived * (commanded - tau);
    state = robcogen::runge_kutta_step(state, step, [&](const State& s) { return held_acceleration(s, tau); });
  }
  add_errors(result);
  return result;
}

}  // namespace tracking
