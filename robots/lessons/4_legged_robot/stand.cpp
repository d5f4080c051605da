// A quadruped stands on four feet, and is pushed.
#include <quadruped/quadruped.h>
#include <robcogen/generic/simulation.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

using quadruped::JointState;
using State = robcogen::State<quadruped::Robot>;
using Feet = Eigen::Matrix<double, 12, 1>;  // x, y, z of each foot: LF, RF, LH, RH

const JointState still = JointState::Zero();

// Knees inwards. A document may have parts, here legs, so that code can loop over them.
JointState posture() {
  JointState q;
  for (const robcogen::Limb& leg : quadruped::limbs) {
    const double front = std::string_view(leg.name)[1] == 'F' ? 1 : -1;
    q[leg.joint("HAA")] = 0;
    q[leg.joint("HFE")] = 0.6 * front;
    q[leg.joint("KFE")] = -1.2 * front;
  }
  return q;
}

// Torques and forces of the feet, in base axes, of a robot at rest.
auto hold(const JointState& q, const robcogen::Gravity& gravity) {
  const Feet weights = Feet::Ones();
  const Eigen::Matrix<double, 1, 1> regularization(0.0);
  return quadruped::constrained_inverse_dynamics(
      q, still, still, robcogen::Twist(), robcogen::SpatialAcceleration(), weights, regularization, gravity);
}

void print_standing(const char* name, const robcogen::BasePose& pose) {
  const robcogen::Gravity gravity = gravity_in_base(pose);
  const auto held = hold(posture(), gravity);
  std::printf(
      "%-8s gravity in the base (%5.2f %5.2f %5.2f) m/s^2\n", name, gravity.vector().x(), gravity.vector().y(),
      gravity.vector().z());
  double lift = 0;
  for (int foot = 0; foot < 4; ++foot) {
    const Eigen::Vector3d force = pose.to_world_axes(held.contact_wrenches.segment<3>(3 * foot));
    lift += force.z();
    std::printf(
        "  foot %s pushes with %6.1f N upwards, knee torque %6.1f N m\n", quadruped::limbs[foot].name, force.z(),
        held.tau[3 * foot + 2]);
  }
  std::printf("  together %.1f N; the weight is %.1f N\n", lift, 9.81 * quadruped::kTotalMass);
}

int main() {
  print_standing("level", robcogen::BasePose());
  print_standing("uphill", robcogen::BasePose::from_rpy(0, -0.2, 0));

  // The simulation. The feet stay where they are; a push of 200 N to the left acts on the trunk from 0.1 s to 0.2 s.
  State state;
  state.q = posture();
  const Eigen::Matrix4d X = quadruped::transforms::homogeneous::fr_trunk_X_fr_LF_foot(state.q);
  state.pose = robcogen::BasePose::from_rpy(0, 0, 0, Eigen::Vector3d(0, 0, -X(2, 3)));
  const JointState q_wanted = state.q, tau_wanted = hold(state.q, gravity_in_base(state.pose)).tau;
  double least = HUGE_VAL, friction = 0;
  std::printf("pushed   height of the trunk %.3f m\n", state.pose.position().z());
  for (int cycle = 0; cycle <= 1000; ++cycle) {
    if (cycle % 100 == 0 && cycle <= 600)
      std::printf(
          "  %.1f s  trunk moved by %5.1f mm, at %6.3f m/s\n", cycle / 1000.0, 1000 * state.pose.position().y(),
          state.pose.to_world_axes(state.base_velocity.linear()).y());

    const JointState tau = tau_wanted + 800 * (q_wanted - state.q) - 60 * state.qd;

    quadruped::LinkWrenches external;
    const double push = cycle >= 100 && cycle < 200 ? 200 : 0;
    external[quadruped::Link::trunk] =
        robcogen::Wrench(Eigen::Vector3d::Zero(), state.pose.to_base_axes(Eigen::Vector3d(0, push, 0)));
    const Feet velocity = quadruped::contact_velocity(state.q, state.qd, state.base_velocity);
    const Feet acceleration = -100 * velocity, rigid = Feet::Zero();
    const Eigen::Vector4d on_ground = Eigen::Vector4d::Ones();
    const auto motion = quadruped::constrained_forward_dynamics(
        state.q, state.qd, tau, state.base_velocity, acceleration, on_ground, rigid, gravity_in_base(state.pose),
        external);
    for (int foot = 0; foot < 4; ++foot) {
      const Eigen::Vector3d force = state.pose.to_world_axes(motion.contact_wrenches.segment<3>(3 * foot));
      least = std::min(least, force.z());
      friction = std::max(friction, force.head<2>().norm() / force.z());
    }
    state = integrate(state, motion, 1e-3);
  }
  std::printf("  a foot carries at least %.0f N, and needs a friction of %.2f\n", least, friction);
}
