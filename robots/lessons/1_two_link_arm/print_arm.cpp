// Kinematics and dynamics of the arm in one state.
#include <arm/arm.h>

#include <iostream>

int main() {
  const arm::JointState q(0.5, 0.8);    // rad: shoulder, elbow
  const arm::JointState qd(1.0, -0.5);  // rad/s
  const arm::JointState qdd(0.0, 2.0);  // rad/s^2

  const arm::InertiaMatrix H = arm::joint_space_inertia(q);
  const arm::JointState tau = arm::inverse_dynamics(q, qd, qdd);
  const arm::JointState back = arm::forward_dynamics(q, qd, tau);
  const arm::JointState hold = arm::gravity_forces(arm::JointState::Zero());
  const Eigen::Matrix4d X = arm::transforms::homogeneous::fr_base_X_tool(q);
  const auto J = arm::jacobians::fr_base_J_tool(q);  // rows: angular velocity, then linear velocity

  std::cout.precision(4);
  std::cout << "hold the arm out straight [N m]  " << hold.transpose() << '\n'
            << "H [kg m^2]\n"
            << H << '\n'
            << "tau [N m]                        " << tau.transpose() << '\n'
            << "qdd from tau [rad/s^2]           " << back.transpose() << '\n'
            << "tool in the base [m]             " << X.topRightCorner<3, 1>().transpose() << '\n'
            << "its velocity [m/s]               " << (J * qd).tail<3>().transpose() << '\n';
}
