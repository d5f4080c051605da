// Energy and momentum, summed over the links and the rotors on them.
#pragma once

#include "robcogen/reference/dynamics.h"

namespace robcogen::reference {

// In J. The base contributes with its twist, which is zero for a fixed base.
template <class Scalar>
Scalar kinetic_energy(const Robot& robot, const Motion<Scalar>& motion) {
  const std::vector<LinkMotion<Scalar>> links = link_motions(robot, motion);
  Scalar energy(0);
  for (int i = 0; i < robot.links.size; ++i) {
    const LinkMotion<Scalar>& link = links[static_cast<std::size_t>(i)];
    // In link axes, where the inertia is constant.
    const Vector<Scalar> w = transpose(rotation_of(link.pose)) * link.angular_velocity();
    const Vector<Scalar> v = link.velocity(center_of_mass<Scalar>(robot.links[i]));
    energy += (dot(w, central_inertia<Scalar>(robot.links[i]) * w) + Scalar(robot.links[i].mass) * dot(v, v)) / 2;
  }
  return energy + energy_of_drives(robot, motion.qd, links);
}

// The first moving link: all links from this one on move, so a fixed base is excluded.
inline int first_moving_link(const Robot& robot) {
  return robot.floating_base ? 0 : 1;
}

// The mass (kg) of the moving links.
inline double moving_mass(const Robot& robot) {
  double mass = 0;
  for (int i = first_moving_link(robot); i < robot.links.size; ++i) mass += robot.links[i].mass;
  return mass;
}

// Mass times position of the centre of mass of the moving links: kg m, base coordinates.
template <class Scalar>
Vector<Scalar> first_moment(const Robot& robot, const Vector<Scalar>& q) {
  const std::vector<Matrix<Scalar>> poses = link_poses(robot, q);
  Vector<Scalar> sum(3);
  for (int i = first_moving_link(robot); i < robot.links.size; ++i) {
    const Matrix<Scalar>& pose = poses[static_cast<std::size_t>(i)];
    const Vector<Scalar> com = rotation_of(pose) * center_of_mass<Scalar>(robot.links[i]) + origin_of(pose);
    sum += Scalar(robot.links[i].mass) * com;
  }
  return sum;
}

// In J; zero when the centre of mass of the moving links is at the base origin. Gravity (m/s^2) is in base coordinates.
template <class Scalar>
Scalar potential_energy(const Robot& robot, const Vector<Scalar>& q, const Vector<Scalar>& gravity) {
  return -dot(gravity, first_moment(robot, q));
}

// Angular momentum about the base origin (N m s), then linear momentum (N s), base coordinates.
template <class Scalar>
Vector<Scalar> momentum(const Robot& robot, const Motion<Scalar>& motion) {
  const std::vector<LinkMotion<Scalar>> links = link_motions(robot, motion);
  Vector<Scalar> total(6);
  for (int i = 0; i < robot.links.size; ++i) {
    const LinkMotion<Scalar>& link = links[static_cast<std::size_t>(i)];
    const Vector<Scalar> com = center_of_mass<Scalar>(robot.links[i]);
    const Matrix<Scalar> R = rotation_of(link.pose);
    const Vector<Scalar> linear = Scalar(robot.links[i].mass) * link.velocity(com);
    const Vector<Scalar> spin = R * central_inertia<Scalar>(robot.links[i]) * (transpose(R) * link.angular_velocity());
    total += stacked(spin + cross(link.position(com), linear), linear);
  }
  return total + stacked(momentum_of_rotors(robot, motion.qd, links), Vector<Scalar>(3));
}

}  // namespace robcogen::reference
