// Kinematics and dynamics of the HyL leg in one state.
#include <hyl/hyl.h>

#include <iostream>

int main() {
  // Joints in the order of the document: SLIDE (m), HFE (rad), KFE (rad).
  const hyl::JointState q(0.64, -0.65, 1.34);
  const hyl::JointState qd(0.0, 0.5, -1.0);
  const hyl::JointState qdd(1.0, 0.5, 2.0);

  const hyl::JointState tau = hyl::inverse_dynamics(q, qd, qdd);
  const hyl::JointState back = hyl::forward_dynamics(q, qd, tau);
  const auto base_X_foot = hyl::transforms::homogeneous::fr_base_X_fr_foot(q);
  const auto base_J_foot = hyl::jacobians::fr_base_J_fr_foot(q);  // rows: angular, then linear

  std::cout.precision(4);
  std::cout << "HyL\n"
            << "H(q) =\n"
            << hyl::joint_space_inertia(q) << '\n'
            << "tau [N, N m, N m]             = " << tau.transpose() << '\n'
            << "qdd [m/s^2, rad/s^2, rad/s^2] = " << back.transpose() << '\n'
            << "position of the foot [m]      = " << base_X_foot.topRightCorner<3, 1>().transpose() << '\n'
            << "velocity of the foot [m/s]    = " << (base_J_foot * qd).tail<3>().transpose() << "\n\n";
}
