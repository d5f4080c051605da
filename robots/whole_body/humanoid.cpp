#include "humanoid.h"

namespace whole_body {

namespace homogeneous = humanoid_on_soles::transforms::homogeneous;
using humanoid_on_soles::Joint;

std::array<Matrix4d, 2> Humanoid::contact_frames(const Robot::JointState& q) {
  return {homogeneous::fr_pelvis_X_fr_left_sole(q), homogeneous::fr_pelvis_X_fr_right_sole(q)};
}

// The corners of a sole of 0.2 x 0.12 m.
std::array<Vector3d, 4> Humanoid::contact_points() {
  constexpr double kLength = 0.1, kWidth = 0.06;  // halves
  return {
      Vector3d(kLength, kWidth, 0), Vector3d(kLength, -kWidth, 0), Vector3d(-kLength, kWidth, 0),
      Vector3d(-kLength, -kWidth, 0)};
}

// A posture with bent knees and elbows.
Humanoid::Robot::JointState Humanoid::posture() {
  Robot::JointState q = Robot::JointState::Zero();
  for (const Joint hip : {Joint::left_hip_pitch, Joint::right_hip_pitch}) q[index(hip)] = -0.35;
  for (const Joint knee : {Joint::left_knee, Joint::right_knee}) q[index(knee)] = 0.7;
  for (const Joint ankle : {Joint::left_ankle_pitch, Joint::right_ankle_pitch}) q[index(ankle)] = -0.35;
  for (const Joint elbow : {Joint::left_elbow, Joint::right_elbow}) q[index(elbow)] = -0.6;
  return q;
}

std::vector<std::vector<Vector3d>> Humanoid::skeleton(const Robot::JointState& q) {
  const auto origin = [](const Matrix4d& X) { return Vector3d(X.topRightCorner<3, 1>()); };
  const Vector3d neck = origin(homogeneous::fr_pelvis_X_fr_neck(q)), hips(0, 0, 0);
  return {
      {neck, origin(homogeneous::fr_pelvis_X_fr_left_shoulder(q)),
       origin(homogeneous::fr_pelvis_X_fr_left_elbow_block(q)), origin(homogeneous::fr_pelvis_X_fr_left_palm(q))},
      {neck, origin(homogeneous::fr_pelvis_X_fr_right_shoulder(q)),
       origin(homogeneous::fr_pelvis_X_fr_right_elbow_block(q)), origin(homogeneous::fr_pelvis_X_fr_right_palm(q))},
      {hips, origin(homogeneous::fr_pelvis_X_fr_left_thigh(q)), origin(homogeneous::fr_pelvis_X_fr_left_shank(q)),
       origin(homogeneous::fr_pelvis_X_fr_left_foot(q)), origin(homogeneous::fr_pelvis_X_fr_left_sole(q))},
      {hips, origin(homogeneous::fr_pelvis_X_fr_right_thigh(q)), origin(homogeneous::fr_pelvis_X_fr_right_shank(q)),
       origin(homogeneous::fr_pelvis_X_fr_right_foot(q)), origin(homogeneous::fr_pelvis_X_fr_right_sole(q))},
      {hips, origin(homogeneous::fr_pelvis_X_fr_chest(q)), neck, origin(homogeneous::fr_pelvis_X_fr_eyes(q))}};
}

}  // namespace whole_body
