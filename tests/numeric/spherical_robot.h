// Random robots with spherical joints, and the same robots with three revolute joints in place of each.
#pragma once

#include <cstdint>

#include "model/kinematic_tree.h"
#include "robcogen/reference/matrix.h"

namespace robcogen::numeric {

// Some joints of the robot become spherical ones, with drives or without.
model::KinematicTree with_spherical_joints(
    const model::KinematicTree& robot,
    std::uint64_t seed,
    bool have_drives = true);

// A robot with spherical joints, and one whose joints `<name>_x`, `<name>_y`, `<name>_z` are revolute ones instead,
// with massless links between them: R = Rz(a) Ry(-b) Rz(c), or with Rx(90) in front (`other`), so that the orientations
// at their poles, where b is 0, are others.
struct EulerRobot {
  model::KinematicTree robot;
  bool other = false;
};
EulerRobot with_euler_angles(const model::KinematicTree& spherical, bool other = false);

using Positions = reference::Vector<double>;

// What the angles of the revolute joints and their rates mean for the robot with spherical joints.
struct SphericalState {
  Positions q, qd, qdd;
  reference::Matrix<double> G;  // qd of the spherical robot by that of the other one, without a base
};
SphericalState spherical_state(
    const model::KinematicTree& spherical,
    const EulerRobot& euler,
    const Positions& q,
    const Positions& qd,
    const Positions& qdd);

// The angles of the other kind for the orientations that those of the first kind make, which are not at a pole of
// theirs.
Positions other_angles(const model::KinematicTree& spherical, const EulerRobot& from, const Positions& q);

}  // namespace robcogen::numeric
