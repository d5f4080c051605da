#include "stand.h"

#include <robcogen/generic/simulation.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "posture.h"

namespace optimal_control {
namespace {

using quadruped::Gravity, quadruped::JointState, quadruped::SpatialAcceleration, quadruped::Twist;
using State = robcogen::State<quadruped::Robot>;
using Base = Eigen::Matrix<double, 6, 1>;
using Base6 = Eigen::Matrix<double, 6, 6>;
using Coordinates = Eigen::Matrix<double, 18, 1>;

const quadruped::Parameters<> kHyq;
const Gravity kGravity(0, 0, -9.81);
const JointState kStill = JointState::Zero();

// Weights of the regulator: a rotation of 0.1 rad counts as much as 0.1 m, as a velocity of 1 rad/s or 1 m/s, and as
// torques of 100 N m.
constexpr double kPositionWeight = 100, kVelocityWeight = 1, kTorqueWeight = 1e-4;
// Feet that have slipped by rounding errors return within some 1/kHold seconds.
constexpr double kHold = 50;
constexpr int kStepsPerControl = 10;

// The forces on the base and in the joints that are needed in addition to the foot forces, for accelerations of both.
Coordinates missing(const JointState& q, const Coordinates& a, const Vector12& forces, const Gravity& gravity) {
  const auto f = inverse_dynamics_with_contacts(
      kHyq, q, kStill, JointState(a.tail<12>()), Twist(), SpatialAcceleration(Base(a.head<6>())), forces, gravity);
  return (Coordinates() << f.base_wrench.vector(), f.tau).finished();
}

// The derivative of all coordinates by the displacement of the trunk while the feet stay in place.
Eigen::Matrix<double, 18, 6> following(const JointState& q) {
  const Eigen::Matrix<double, 12, 18> J = contact_jacobian(kHyq, q);
  Eigen::Matrix<double, 18, 6> N;
  N << Base6::Identity(), -J.rightCols<12>().partialPivLu().solve(J.leftCols<6>());
  return N;
}

Vector12 as_state(const State& s, const Standing& about) {
  const robcogen::BasePose pose = robcogen::BasePose::from_rpy(0, 0, 0, Eigen::Vector3d(0, 0, about.height));
  return (Vector12() << difference(pose, s.pose).vector(), s.base_velocity.vector()).finished();
}

}  // namespace

// With x the displacement of the trunk, N^T (inverse dynamics) = N^T (0, tau) holds for all motions with the feet at
// rest. Its derivatives are those of inverse dynamics with constant forces on the feet, because N^T J^T = 0 for every
// posture.
Standing standing(double height) {
  Standing s{};
  s.height = height;
  s.q = design::posture(kHyq, design::feet_below_hips(-height), design::bent_knees());
  const auto held = constrained_inverse_dynamics(
      kHyq, s.q, kStill, kStill, Twist(), SpatialAcceleration(), Vector12::Ones(), Eigen::Matrix<double, 1, 1>::Zero(),
      kGravity);
  s.tau = held.tau;
  s.forces = held.contact_wrenches;

  const Eigen::Matrix<double, 18, 6> N = following(s.q);
  const Coordinates at_rest = missing(s.q, Coordinates::Zero(), s.forces, kGravity);
  Eigen::Matrix<double, 18, 6> inertia, stiffness;
  const auto d =
      inverse_dynamics_with_contacts_d_q(kHyq, s.q, kStill, kStill, Twist(), SpatialAcceleration(), s.forces, kGravity);
  Eigen::Matrix<double, 18, 12> by_q;
  by_q << d.base_wrench_d_q, d.tau_d_q;
  for (int k = 0; k < 6; ++k) {
    // Forces are linear in accelerations and in gravity, which in trunk axes turns opposite to the trunk.
    inertia.col(k) = missing(s.q, N.col(k), s.forces, kGravity) - at_rest;
    const Eigen::Vector3d g = kGravity.vector(), turn = Base::Unit(k).head<3>();
    stiffness.col(k) = by_q * N.col(k).tail<12>() +
                       missing(s.q, Coordinates::Zero(), s.forces, Gravity(Eigen::Vector3d(g - turn.cross(g)))) -
                       at_rest;
  }
  const Eigen::LLT<Base6> mass(N.transpose() * inertia);
  Matrix12 rate = Matrix12::Zero(), input = Matrix12::Zero();
  rate.topRightCorner<6, 6>().setIdentity();
  rate.bottomLeftCorner<6, 6>() = -mass.solve(N.transpose() * stiffness);
  input.bottomRows<6>() = mass.solve(N.bottomRows<12>().transpose());
  s.rate = rate;

  // A is the exponential of rate times the time step, B its integral times the input; the series converge quickly.
  Matrix12 power = Matrix12::Identity(), sum = Matrix12::Zero();
  s.A.setZero();
  for (int k = 1; k < 12; ++k) {
    s.A += power;
    sum += power * (kControlStep / k);
    power = (power * rate * (kControlStep / k)).eval();
  }
  s.B = sum * input;
  return s;
}

// Solves the Riccati equation by doubling (Anderson 1978; Chu, Fan, Lin, Wang 2004): each step doubles the horizon.
Matrix12 regulator(const Matrix12& A, const Matrix12& B, const Vector12& state_weights, double torque_weight) {
  Matrix12 a = A, g = B * B.transpose() / torque_weight, h = state_weights.asDiagonal();
  for (int i = 0; i < 60; ++i) {
    const Eigen::PartialPivLU<Matrix12> w(Matrix12::Identity() + g * h);
    const Matrix12 v = w.solve(a), before = h;
    g += a * w.solve(g) * a.transpose();
    h += a.transpose() * h * v;
    a = (a * v).eval();
    if ((h - before).norm() > 1e-13 * h.norm()) continue;
    const Matrix12 quadratic = Matrix12(torque_weight * Matrix12::Identity()) + B.transpose() * h * B;
    return -quadratic.llt().solve(B.transpose() * h * A);
  }
  throw std::runtime_error("the Riccati equation does not converge: can the torques reach every state?");
}

Matrix12 regulator(const Standing& s) {
  Vector12 weights;
  weights << Base::Constant(kPositionWeight), Base::Constant(kVelocityWeight);
  return regulator(s.A, s.B, weights, kTorqueWeight);
}

Vector12 closed_loop_moduli(const Standing& s, const Matrix12& K) {
  return (s.A + s.B * K).eigenvalues().cwiseAbs();
}

std::vector<Instant> push(const Standing& s, const Matrix12& K, const Base& velocity, double duration) {
  State state;
  state.q = s.q;
  state.pose = robcogen::BasePose::from_rpy(0, 0, 0, Eigen::Vector3d(0, 0, s.height));
  state.base_velocity = Twist(velocity);
  state.qd = following(s.q).bottomRows<12>() * velocity;
  Vector12 places = design::feet_positions(kHyq, s.q);
  for (int foot = 0; foot < 4; ++foot) places[3 * foot + 2] = 0;  // in the world

  std::vector<Instant> instants;
  JointState tau = s.tau;
  const int steps = static_cast<int>(std::lround(duration / kControlStep)) * kStepsPerControl;
  for (int i = 0; i <= steps; ++i) {
    const bool is_control = i % kStepsPerControl == 0;
    if (is_control) tau = s.tau + K * as_state(state, s);
    const Vector12 now = design::feet_positions(kHyq, state.q),
                   moving = contact_velocity(kHyq, state.q, state.qd, state.base_velocity);
    Vector12 hold = -2 * kHold * moving;
    for (int foot = 0; foot < 4; ++foot) {
      const Eigen::Vector3d place = state.pose.position() + state.pose.to_world_axes(now.segment<3>(3 * foot));
      hold.segment<3>(3 * foot) -= kHold * kHold * state.pose.to_base_axes(place - places.segment<3>(3 * foot));
    }
    const auto motion = constrained_forward_dynamics(
        kHyq, state.q, state.qd, tau, state.base_velocity, hold, Eigen::Vector4d::Ones(), Vector12::Zero(),
        gravity_in_base(state));
    if (is_control) {
      Instant instant{i / kStepsPerControl * kControlStep, as_state(state, s), HUGE_VAL, 0};
      for (int foot = 0; foot < 4; ++foot) {
        const Eigen::Vector3d force = state.pose.to_world_axes(motion.contact_wrenches.segment<3>(3 * foot));
        instant.least_force = std::min(instant.least_force, force.z());
        instant.most_friction = std::max(instant.most_friction, force.head<2>().norm() / force.z());
      }
      instants.push_back(instant);
    }
    state = integrate(state, motion, kControlStep / kStepsPerControl);
  }
  return instants;
}

}  // namespace optimal_control
