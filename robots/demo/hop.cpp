#include "hop.h"

#include <hyl/hyl.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace demo {
namespace {

using hyl::JointState;

// The ground acts upwards as a spring whose stiffness grows with the speed of sinking (so the force starts at zero),
// and forwards as a damper whose force stays within the friction cone.
constexpr double kGroundStiffness = 5e4;  // N/m
constexpr double kGroundDamping = 1.5;    // s/m
constexpr double kSlipDamping = 400;      // N s/m
constexpr double kFriction = 0.8;

// Joint controller.
const Eigen::Vector2d kCrouched(-0.65, 1.34);  // HFE, KFE in rad: the foot is below the hip in both postures
const Eigen::Vector2d kStretched(-0.35, 0.72);
constexpr double kStiffness = 120;  // N m/rad
constexpr double kDamping = 5;      // N m s/rad

constexpr double kDropHeight = 0.3;  // m, of the foot above the ground at the start
constexpr double kTimeStep = 1e-4;   // s
constexpr int kStepsPerInstant = 40;

struct State {
  JointState q;   // m, rad, rad
  JointState qd;  // m/s, rad/s, rad/s
};

Eigen::Vector3d foot_position(const JointState& q) {
  return hyl::transforms::homogeneous::fr_base_X_fr_foot(q).topRightCorner<3, 1>();
}

// Force of the ground on the foot, base axes.
Eigen::Vector3d ground_force(const State& state) {
  const double depth = -foot_position(state.q).z();
  if (depth <= 0) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d velocity = hyl::jacobians::fr_base_J_fr_foot(state.q).bottomRows<3>() * state.qd;
  const double normal = kGroundStiffness * depth * std::max(0.0, 1 - kGroundDamping * velocity.z());
  const double friction = std::clamp(-kSlipDamping * velocity.x(), -kFriction * normal, kFriction * normal);
  return {friction, 0, normal};
}

// Holds a posture: gravity compensation, and a spring and a damper at each joint of the leg. On the ground the leg
// carries the weight of the robot as well, and pushes off (posture stretched) as soon as it has caught the fall. The
// slider is not driven.
JointState control(const State& state) {
  const bool on_ground = foot_position(state.q).z() < 0;
  const bool push_off = on_ground && state.qd[0] > 0;
  const Eigen::Vector2d posture = push_off ? kStretched : kCrouched;

  JointState tau = hyl::gravity_forces(state.q);
  tau.tail<2>() += kStiffness * (posture - state.q.tail<2>()) - kDamping * state.qd.tail<2>();
  if (on_ground) {
    const Eigen::Vector3d support(0, 0, weight());
    tau -= hyl::jacobians::fr_base_J_fr_foot(state.q).bottomRows<3>().transpose() * support;
  }
  tau[0] = 0;
  return tau;
}

JointState acceleration(const State& state) {
  // The wrench of the ground about the base origin, in base axes, and then in coordinates of the lower leg.
  const Eigen::Vector3d force = ground_force(state);
  Eigen::Matrix<double, 6, 1> wrench;
  wrench << foot_position(state.q).cross(force), force;
  hyl::LinkWrenches external;
  external[hyl::Link::lowerleg] = robcogen::Wrench(hyl::transforms::force::fr_lowerleg_X_fr_base(state.q) * wrench);
  return hyl::forward_dynamics(state.q, state.qd, control(state), external);
}

// Semi-implicit Euler.
State step(const State& state) {
  const JointState qd = state.qd + kTimeStep * acceleration(state);
  return {state.q + kTimeStep * qd, qd};
}

Instant record(double time, const State& state) {
  const auto in_plane = [](const auto& pose) { return Eigen::Vector2d(pose(0, 3), pose(2, 3)); };
  using namespace hyl::transforms::homogeneous;
  return {
      time, in_plane(fr_base_X_fr_upperleg(state.q)), in_plane(fr_base_X_fr_lowerleg(state.q)),
      in_plane(fr_base_X_fr_foot(state.q)), ground_force(state).z()};
}

}  // namespace

double weight() {
  // Lifting the slider lifts the whole robot.
  return hyl::gravity_forces(JointState::Zero())[0];
}

std::vector<Instant> hop(double duration) {
  State state{JointState(0, kCrouched[0], kCrouched[1]), JointState::Zero()};
  state.q[0] = kDropHeight - foot_position(state.q).z();

  std::vector<Instant> instants;
  const int steps = static_cast<int>(std::lround(duration / kTimeStep));
  for (int i = 0; i <= steps; ++i) {
    if (i % kStepsPerInstant == 0) instants.push_back(record(i * kTimeStep, state));
    state = step(state);
  }
  return instants;
}

}  // namespace demo
