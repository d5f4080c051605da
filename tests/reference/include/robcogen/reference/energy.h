// Energy and momentum, summed over the links.
#pragma once

#include "robcogen/reference/dynamics.h"

namespace robcogen::reference {

// J. The base counts with its twist, which is zero for a fixed base.
template <class Scalar>
Scalar kinetic_energy(const Robot& robot, const Motion<Scalar>& motion) {
  const std::vector<LinkMotion<Scalar>> links = link_motions(robot, motion);
  Scalar energy(0);
  for (int i = 0; i < robot.links.size; ++i) {
    const LinkMotion<Scalar>& link = links[static_cast<std::size_t>(i)];
    // In link axes, where the inertia is constant.
    const Vector3<Scalar> w = rotation_of(link.pose).transpose() * link.angular_velocity();
    const Vector3<Scalar> v = link.velocity(center_of_mass<Scalar>(robot.links[i]));
    energy += (w.dot(central_inertia<Scalar>(robot.links[i]) * w) + Scalar(robot.links[i].mass) * v.squaredNorm()) / 2;
  }
  return energy;
}

// J, zero with all mass at the base origin. The base counts; gravity (m/s^2) is in base coordinates.
template <class Scalar>
Scalar potential_energy(const Robot& robot, const VectorX<Scalar>& q, const Vector3<Scalar>& gravity) {
  const std::vector<Matrix4<Scalar>> poses = link_poses(robot, q);
  Scalar energy(0);
  for (int i = 0; i < robot.links.size; ++i) {
    const Matrix4<Scalar>& pose = poses[static_cast<std::size_t>(i)];
    const Vector3<Scalar> com = rotation_of(pose) * center_of_mass<Scalar>(robot.links[i]) + origin_of(pose);
    energy -= Scalar(robot.links[i].mass) * gravity.dot(com);
  }
  return energy;
}

// Angular momentum about the base origin (N m s), then linear momentum (N s), base coordinates.
template <class Scalar>
Vector6<Scalar> momentum(const Robot& robot, const Motion<Scalar>& motion) {
  const std::vector<LinkMotion<Scalar>> links = link_motions(robot, motion);
  Vector6<Scalar> total = Vector6<Scalar>::Zero();
  for (int i = 0; i < robot.links.size; ++i) {
    const LinkMotion<Scalar>& link = links[static_cast<std::size_t>(i)];
    const Vector3<Scalar> com = center_of_mass<Scalar>(robot.links[i]);
    const Matrix3<Scalar> R = rotation_of(link.pose);
    const Vector3<Scalar> linear = Scalar(robot.links[i].mass) * link.velocity(com);
    const Vector3<Scalar> spin =
        R * (central_inertia<Scalar>(robot.links[i]) * (R.transpose() * link.angular_velocity()));
    total.template head<3>() += spin + link.position(com).cross(linear);
    total.template tail<3>() += linear;
  }
  return total;
}

}  // namespace robcogen::reference
