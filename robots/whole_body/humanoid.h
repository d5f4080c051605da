// The humanoid on its soles, each of which touches the ground at its four corners.
#pragma once

#include <humanoid_on_soles/humanoid_on_soles.h>

#include "body.h"

namespace whole_body {

struct Humanoid {
  using Robot = humanoid_on_soles::Robot;
  static constexpr const char* kName = "humanoid";
  static constexpr int kContacts = 2, kPointsPerContact = 4;
  static constexpr double kMass = humanoid_on_soles::kTotalMass;

  static std::array<Matrix4d, kContacts> contact_frames(const Robot::JointState& q);
  static std::array<Vector3d, kPointsPerContact> contact_points();
  static Robot::JointState posture();
  static std::vector<std::vector<Vector3d>> skeleton(const Robot::JointState& q);
};

}  // namespace whole_body
