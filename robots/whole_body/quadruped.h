// The quadruped on its feet, which are contact points.
#pragma once

#include <quadruped_on_feet/quadruped_on_feet.h>

#include "body.h"

namespace whole_body {

struct Quadruped {
  using Robot = quadruped_on_feet::Robot;
  static constexpr const char* kName = "quadruped";
  static constexpr int kContacts = 4, kPointsPerContact = 1;
  static constexpr double kMass = quadruped_on_feet::kTotalMass;

  static std::array<Matrix4d, kContacts> contact_frames(const Robot::JointState& q);
  static std::array<Vector3d, kPointsPerContact> contact_points() { return {Vector3d::Zero()}; }
  static Robot::JointState posture();
  // Lines through its joints, in base coordinates, for pictures.
  static std::vector<std::vector<Vector3d>> skeleton(const Robot::JointState& q);
};

}  // namespace whole_body
