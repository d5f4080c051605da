// Random robots with spherical joints, and the same robots with three revolute joints in place of each.
#pragma once

#include <cstdint>

#include "model/kinematic_tree.h"
#include "robcogen/reference/matrix.h"

namespace robcogen::numeric {

// Makes some joints of the robot spherical, with drives or without.
model::KinematicTree with_spherical_joints(
    const model::KinematicTree& robot,
    std::uint64_t seed,
    bool have_drives = true);

// A robot whose spherical joints are replaced by revolute joints `<name>_x`, `<name>_y`, `<name>_z` with massless links
// between them: R = Rz(a) Ry(-b) Rz(c), or with Rx(90) in front (`other`), so that its pole, where b is 0, is at
// another orientation.
struct EulerRobot {
  model::KinematicTree robot;
  bool other = false;
};
EulerRobot with_euler_angles(const model::KinematicTree& spherical, bool other = false);

using Positions = reference::Vector<double>;

// The state of the robot with spherical joints for given angles, rates and accelerations of the revolute joints.
struct SphericalState {
  Positions q, qd, qdd;
  reference::Matrix<double> G;  // qd of the spherical robot = G * qd of the other one, without a base
};
SphericalState spherical_state(
    const model::KinematicTree& spherical,
    const EulerRobot& euler,
    const Positions& q,
    const Positions& qd,
    const Positions& qdd);

// Returns the angles of the other kind for the orientations that the given angles make. None of these orientations may
// be a pole of the other kind.
Positions other_angles(const model::KinematicTree& spherical, const EulerRobot& from, const Positions& q);

}  // namespace robcogen::numeric
