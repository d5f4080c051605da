// What the library knows about the arm: joint order, limits, friction, frames.
#include <picker/picker.h>
#include <robcogen/conversions.h>

#include <cstdio>
#include <string>
#include <vector>

int main() {
  std::printf("element of q  joint     limits [rad]   damping [N m s/rad]  friction [N m]\n");
  for (int i = 0; i < picker::kDof; ++i) {
    const auto& limits = picker::kJointLimits[i];
    const auto& drive = picker::kJointDrives[i];
    std::printf(
        "%d             %-8s  %4.1f to %4.1f    %-19g  %g\n", i, picker::kJointNames[i], limits.lower, limits.upper,
        drive.damping, drive.friction);
  }

  // A driver that sorts joints by name, as many do.
  const std::vector<std::string> driver_names{"elbow", "roll", "shoulder", "waist"};
  const std::vector<double> driver_positions{1.4, 0.0, -0.9, 0.2};
  const auto match = robcogen::match_joints(picker::kJointNames, driver_names);
  if (!match.order)
    return std::printf("the driver and the model do not agree on joint %s\n", std::string(match.name).c_str()), 1;
  picker::JointState q;
  for (int i = 0; i < picker::kDof; ++i) q[i] = driver_positions[(*match.order)[i]];
  std::printf("\nq from the driver: %.1f %.1f %.1f %.1f\n", q[0], q[1], q[2], q[3]);

  namespace homogeneous = picker::transforms::homogeneous;
  const auto print_z = [](const char* frame, const Eigen::Matrix4d& X) {
    std::printf("z of %-12s points to (%5.2f %5.2f %5.2f)\n", frame, X(0, 2), X(1, 2), X(2, 2));
  };
  print_z("forearm", homogeneous::fr_table_X_forearm(q));
  print_z("fr_forearm", homogeneous::fr_table_X_fr_forearm(q));
  const Eigen::Matrix4d X = homogeneous::fr_table_X_tool(q);
  std::printf("the tool is at (%.3f %.3f %.3f) m\n", X(0, 3), X(1, 3), X(2, 3));
}
