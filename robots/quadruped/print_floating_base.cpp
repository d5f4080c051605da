// Dynamics of a floating base: the quadruped trots downhill, and the ground pushes two of its feet.
#include <quadruped/quadruped.h>

#include <iostream>
#include <string_view>

#include "robcogen/pose.h"
#include "robcogen/world.h"

int main() {
  // Hip abduction, hip flexion and knee of each leg (rad), LF, RF, LH and RH. Front knees forward, hind knees backward.
  quadruped::JointState q;
  for (const robcogen::Limb& leg : quadruped::limbs) {
    const std::string_view name = leg.name;
    const double left = name[0] == 'L' ? 1 : -1, front = name[1] == 'F' ? 1 : -1;
    q[leg.joint("HAA")] = 0.1 * left;
    q[leg.joint("HFE")] = -0.6 * front;
    q[leg.joint("KFE")] = 1.2 * front;
  }
  const quadruped::JointState rest = quadruped::JointState::Zero();

  // All quantities of the base are in its own coordinates: its velocity (angular, then linear), and gravity, which
  // tells how the trunk is tilted. Here its nose points 0.17 rad down, and it rolls and sways a little.
  const robcogen::Twist base_velocity(Eigen::Vector3d(0.2, 0, 0), Eigen::Vector3d(0, 0.1, 0));
  const robcogen::Gravity gravity = robcogen::gravity_in_base(robcogen::BasePose::from_rpy(0, 0.17, 0));

  // The inertia matrix: 18 x 18, the base first; its fourth diagonal element is the total mass.
  const quadruped::InertiaMatrix H = quadruped::joint_space_inertia(q);

  // Two feet bear half of the weight each.
  namespace homogeneous = quadruped::transforms::homogeneous;
  const Eigen::Vector3d force = -H(3, 3) / 2 * gravity.vector();
  const Eigen::Vector3d front = homogeneous::fr_trunk_X_fr_LF_foot(q).topRightCorner<3, 1>();
  const Eigen::Vector3d hind = homogeneous::fr_trunk_X_fr_RH_foot(q).topRightCorner<3, 1>();
  quadruped::LinkWrenches external;
  external[quadruped::Link::LF_lowerleg] =
      robcogen::wrench_on_link(homogeneous::fr_trunk_X_fr_LF_lowerleg(q), front, force);
  external[quadruped::Link::RH_lowerleg] =
      robcogen::wrench_on_link(homogeneous::fr_trunk_X_fr_RH_lowerleg(q), hind, force);

  // Joint forces that keep the joints at rest, and the resulting acceleration of the base.
  const auto held = quadruped::inverse_dynamics(q, rest, rest, base_velocity, gravity, external);
  // Forward dynamics with the same forces: the joints do not accelerate.
  const auto motion = quadruped::forward_dynamics(q, rest, held.tau, base_velocity, gravity, external);
  // The wrench on the trunk that would keep it at rest as well.
  const auto missing = quadruped::inverse_dynamics_fully_actuated(
      q, rest, rest, base_velocity, robcogen::SpatialAcceleration(), gravity, external);

  const Eigen::IOFormat table(3, 0, " ", "\n", "  ");
  const Eigen::IOFormat row(4, Eigen::DontAlignCols, " ", " ");
  std::cout << "Quadruped, floating base\n"
            << "H(q) =\n"
            << H.format(table) << '\n'
            << "tau that keeps the joints still [N m]      = " << held.tau.format(row) << '\n'
            << "qdd under tau [rad/s^2]: largest             " << motion.qdd.cwiseAbs().maxCoeff() << '\n'
            << "base acceleration [rad/s^2, m/s^2]         = " << motion.base_acceleration.vector().format(row) << '\n'
            << "wrench that keeps the base still [N m, N]  = " << missing.base_wrench.vector().format(row) << "\n\n";
}
