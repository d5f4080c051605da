#include "quadruped.h"

namespace whole_body {

namespace homogeneous = quadruped_on_feet::transforms::homogeneous;

std::array<Matrix4d, 4> Quadruped::contact_frames(const Robot::JointState& q) {
  return {
      homogeneous::fr_trunk_X_fr_LF_foot(q), homogeneous::fr_trunk_X_fr_RF_foot(q),
      homogeneous::fr_trunk_X_fr_LH_foot(q), homogeneous::fr_trunk_X_fr_RH_foot(q)};
}

// A posture with knees inwards and feet about below the hips.
Quadruped::Robot::JointState Quadruped::posture() {
  Robot::JointState q;
  for (const robcogen::Limb& leg : Robot::limbs) {
    const double sense = leg.name[1] == 'F' ? 1 : -1;
    q[leg.joint("HAA")] = 0;
    q[leg.joint("HFE")] = 0.6 * sense;
    q[leg.joint("KFE")] = -1.25 * sense;
  }
  return q;
}

std::vector<std::vector<Vector3d>> Quadruped::skeleton(const Robot::JointState& q) {
  const auto origin = [](const Matrix4d& X) { return Vector3d(X.topRightCorner<3, 1>()); };
  const std::vector<std::vector<Vector3d>> legs = {
      {origin(homogeneous::fr_trunk_X_fr_LF_upperleg(q)), origin(homogeneous::fr_trunk_X_fr_LF_lowerleg(q)),
       origin(homogeneous::fr_trunk_X_fr_LF_foot(q))},
      {origin(homogeneous::fr_trunk_X_fr_RF_upperleg(q)), origin(homogeneous::fr_trunk_X_fr_RF_lowerleg(q)),
       origin(homogeneous::fr_trunk_X_fr_RF_foot(q))},
      {origin(homogeneous::fr_trunk_X_fr_LH_upperleg(q)), origin(homogeneous::fr_trunk_X_fr_LH_lowerleg(q)),
       origin(homogeneous::fr_trunk_X_fr_LH_foot(q))},
      {origin(homogeneous::fr_trunk_X_fr_RH_upperleg(q)), origin(homogeneous::fr_trunk_X_fr_RH_lowerleg(q)),
       origin(homogeneous::fr_trunk_X_fr_RH_foot(q))}};
  std::vector<std::vector<Vector3d>> lines = legs;
  lines.push_back({legs[0].front(), legs[1].front(), legs[3].front(), legs[2].front(), legs[0].front()});
  return lines;
}

}  // namespace whole_body
