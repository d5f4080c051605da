// Uses two libraries generated from one URDF: its names, its limits, its frames.
#include <arm/arm.h>
#include <flying_arm/flying_arm.h>

#include <cstdio>

int main() {
  static_assert(!arm::kFloatingBase && flying_arm::kFloatingBase);
  static_assert(arm::kDof == 2);
  static_assert(arm::kJointLimits[arm::index(arm::Joint::shoulder)].upper == 2.5);
  static_assert(arm::Robot::kJointLimits[1].effort == robcogen::kUnlimited);

  // The tool is lumped into the forearm but remains a frame at its place in the URDF: at most 0.4 + 0.3 + 0.2 m from
  // the ground.
  const arm::JointState q = arm::JointState::Zero();
  const Eigen::Matrix4d tool = arm::transforms::homogeneous::fr_stand_X_tool(q);
  const double reach = tool.topRightCorner<3, 1>().norm();
  std::printf("%s: the tool is %.3f m from the stand's origin\n", arm::kName, reach);
  const Eigen::Matrix4d upper_arm = arm::transforms::homogeneous::fr_stand_X_upper_arm(q);
  const bool is_right = reach < 0.9 && std::abs(upper_arm(2, 3) - 0.4) < 1e-15 && std::abs(upper_arm(2, 1) - 1) < 1e-9;
  return is_right ? 0 : 1;
}
