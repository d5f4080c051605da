#include "squat_jump.h"

#include <robcogen/generic/simulation.h>
#include <robcogen/world.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace design {
namespace {

using Eigen::Vector3d;
using quadruped::JointTrigonometry, quadruped::Twist;
using State = robcogen::State<quadruped::Robot>;
using Contacts = Eigen::Matrix<double, 12, 18>;

// The ground acts upwards as a spring whose stiffness grows with the speed of sinking, and tangentially by friction.
constexpr double kGroundStiffness = 2e5;  // N/m
constexpr double kGroundDamping = 1;      // s/m
constexpr double kFriction = 0.8;
constexpr double kSlipVelocity = 0.05;  // m/s, at which friction reaches 0.7 of its limit

// Controller of the trunk.
constexpr double kPush = 2.5;                                  // times the weight
constexpr double kLevelStiffness = 3000, kLevelDamping = 200;  // N m/rad, N m s/rad
constexpr double kDriftDamping = 500;                          // N s/m, forwards and sideways
// Controller of the legs in the air, which holds their posture.
constexpr double kHoldStiffness = 200, kHoldDamping = 10;

constexpr double kTimeStep = 5e-5;  // s
constexpr int kStepsPerControl = 10;
constexpr int kStepsPerInstant = 20;
constexpr double kFlightTimeStep = 5e-4;  // s; without the ground, nothing is stiff
constexpr double kMaxPushTime = 1, kMaxFlightTime = 2;

// Motors: the torque is proportional to the inertia of the rotor, 5 N m for 1e-4 kg m^2; 800 rad/s without load.
constexpr double kTorquePerInertia = 5e4;
constexpr double kNoLoadVelocity = 800;

// The wrench that the ground exerts on the robot at rest: minus its weight and the moment of the weight, about the
// base.
Eigen::Matrix<double, 6, 1> standing_wrench(const Parameters& parameters, const JointState& q) {
  const JointState zero = JointState::Zero();
  const auto standing = constrained_inverse_dynamics(
      parameters, q, zero, zero, Twist(), quadruped::SpatialAcceleration(), Feet::Ones(),
      Eigen::Matrix<double, 1, 1>::Zero(), quadruped::Gravity(0, 0, -9.81));
  return contact_jacobian(parameters, q).leftCols<6>().transpose() * standing.contact_wrenches;
}

// Forces of the ground on the feet, in trunk axes; all zero in the air. Sets `depth` to that of the deepest foot (m).
Feet ground_forces(const State& state, const Feet& positions, const Feet& velocities, double& depth) {
  Feet forces = Feet::Zero();
  depth = -HUGE_VAL;
  for (int foot = 0; foot < 4; ++foot) {
    const Vector3d position = state.pose.position() + state.pose.to_world_axes(positions.segment<3>(3 * foot));
    depth = std::max(depth, -position.z());
    if (position.z() >= 0) continue;
    const Vector3d velocity = state.pose.to_world_axes(velocities.segment<3>(3 * foot));
    const double normal = -kGroundStiffness * position.z() * std::max(0.0, 1 - kGroundDamping * velocity.z());
    const double slip = velocity.head<2>().norm();
    Vector3d force(0, 0, normal);
    force.head<2>() = -kFriction * normal / std::hypot(slip, kSlipVelocity) * velocity.head<2>();
    forces.segment<3>(3 * foot) = state.pose.to_base_axes(force);
  }
  return forces;
}

JointState limited(const JointState& tau, const TorqueLimits& limits) {
  return tau.cwiseMax(limits.lower).cwiseMin(limits.upper);
}

// Joint torques that push the trunk, with the smallest forces on the feet that achieve this.
JointState push(const State& state, const Contacts& J, const Eigen::Matrix<double, 6, 1>& weight) {
  Eigen::Matrix<double, 6, 1> wrench = kPush * weight;
  const Vector3d turn = difference(state.pose, robcogen::BasePose()).angular();
  wrench.head<3>() += kLevelStiffness * turn - kLevelDamping * state.base_velocity.angular();
  const Vector3d velocity = state.pose.to_world_axes(state.base_velocity.linear());
  wrench.tail<3>() -= state.pose.to_base_axes(kDriftDamping * Vector3d(velocity.x(), velocity.y(), 0));
  const Eigen::Matrix<double, 6, 12> G = J.leftCols<6>().transpose();
  const Eigen::Matrix<double, 6, 6> normal = G * G.transpose();
  const Feet forces = G.transpose() * normal.llt().solve(wrench);
  return -J.rightCols<12>().transpose() * forces;
}

JointState hold(const State& state, const JointState& posture) {
  return kHoldStiffness * (posture - state.q) - kHoldDamping * state.qd;
}

quadruped::LinkWrenches on_links(
    const Parameters& parameters,
    const JointTrigonometry& at,
    const Feet& positions,
    const Feet& forces) {
  using quadruped::Link;
  namespace homogeneous = quadruped::transforms::homogeneous;
  quadruped::LinkWrenches external;
  const auto add = [&](int foot, Link link, const Eigen::Matrix4d& X) {
    external[link] = robcogen::wrench_on_link<double>(
        X, Vector3d(positions.segment<3>(3 * foot)), Vector3d(forces.segment<3>(3 * foot)));
  };
  add(0, Link::LF_lowerleg, homogeneous::fr_trunk_X_fr_LF_lowerleg(parameters, at));
  add(1, Link::RF_lowerleg, homogeneous::fr_trunk_X_fr_RF_lowerleg(parameters, at));
  add(2, Link::LH_lowerleg, homogeneous::fr_trunk_X_fr_LH_lowerleg(parameters, at));
  add(3, Link::RH_lowerleg, homogeneous::fr_trunk_X_fr_RH_lowerleg(parameters, at));
  return external;
}

double vertical_speed(const State& state) {
  return state.pose.to_world_axes(state.base_velocity.linear()).z();
}

// Simulates the flight and returns the height of the apex.
double fly(const Parameters& parameters, State state, const Actuators& actuators) {
  const JointState posture = state.q;
  for (double time = 0; time < kMaxFlightTime; time += kFlightTimeStep) {
    const JointState tau = limited(hold(state, posture), actuators(state.qd));
    const double before = vertical_speed(state), height = state.pose.position().z();
    state = integrate(
        state, forward_dynamics(parameters, state.q, state.qd, tau, state.base_velocity, gravity_in_base(state)),
        kFlightTimeStep);
    const double now = vertical_speed(state);
    if (now <= 0) return height + (state.pose.position().z() - height) * (before > 0 ? before / (before - now) : 0);
  }
  throw std::domain_error("the robot does not come down");
}

}  // namespace

Actuators constant_limit(double torque) {
  const TorqueLimits limits{JointState::Constant(-torque), JointState::Constant(torque)};
  return [limits](const JointState&) { return limits; };
}

Actuators motors(const ParameterArray& parameters) {
  const quadruped::ParameterValues values = Parameters(parameters).values();
  const double torque = values.gear_ratio * kTorquePerInertia * values.rotor_inertia;
  const double no_load = kNoLoadVelocity / values.gear_ratio;
  return [=](const JointState& qd) -> TorqueLimits {
    return {
        -torque * (1 + qd.array() / no_load).max(0).min(1).matrix(),
        torque * (1 - qd.array() / no_load).max(0).min(1).matrix()};
  };
}

Jump squat_jump(const Parameters& parameters, double start, const Actuators& actuators) {
  State state;
  state.q = posture(parameters, feet_below_hips(-start), bent_knees());
  const Eigen::Matrix<double, 6, 1> weight = standing_wrench(parameters, state.q);
  // The ground carries the weight from the start.
  const double sunk = weight[5] / (4 * kGroundStiffness);
  state.pose = robcogen::BasePose::from_rpy(0, 0, 0, Vector3d(0, 0, start - sunk));

  Jump jump{};
  JointState tau = JointState::Zero();
  double depth = sunk, height = state.pose.position().z();
  for (int i = 0; i * kTimeStep < kMaxPushTime; ++i) {
    const JointTrigonometry at(parameters, state.q);
    const Contacts J = contact_jacobian(parameters, at);
    const Feet positions = feet_positions(parameters, state.q);
    Eigen::Matrix<double, 18, 1> velocity;
    velocity << state.base_velocity.vector(), state.qd;
    const double before = depth;
    const Feet forces = ground_forces(state, positions, J * velocity, depth);
    if (i % kStepsPerInstant == 0) jump.feet.push_back(positions);
    if (depth <= 0 && vertical_speed(state) > 0) {
      // Lift-off is between the last two steps.
      const double share = before > 0 ? before / (before - depth) : 1;
      const double lift_off = height + share * (state.pose.position().z() - height);
      jump.lift_off_time = (i - 1 + share) * kTimeStep;
      jump.lift_off_speed = vertical_speed(state);
      jump.rise = fly(parameters, state, actuators) - lift_off;
      return jump;
    }
    height = state.pose.position().z();
    if (height < start / 2) throw std::domain_error("the legs are too weak for the robot");
    if (i % kStepsPerControl == 0) tau = limited(push(state, J, weight), actuators(state.qd));
    state = integrate(
        state,
        forward_dynamics(
            parameters, at, state.qd, tau, state.base_velocity, gravity_in_base(state),
            on_links(parameters, at, positions, forces)),
        kTimeStep);
  }
  throw std::domain_error("the robot does not lift off");
}

}  // namespace design
