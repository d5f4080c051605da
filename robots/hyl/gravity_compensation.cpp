// A joint controller in one line: gravity compensation with a spring and a damper, tested on the simulated leg.
#include <hyl/hyl.h>

#include <iostream>

using hyl::JointState;

// Forces that pull the joints to `goal`. It has no state and allocates nothing, so a real-time loop can call it.
JointState control(const JointState& q, const JointState& qd, const JointState& goal) {
  const JointState stiffness(4000, 150, 150), damping(400, 10, 5);
  return hyl::gravity_forces(q) + stiffness.cwiseProduct(goal - q) - damping.cwiseProduct(qd);
}

int main() {
  const JointState goal(0.64, -0.65, 1.34);
  JointState q(0.6, 0.0, 0.6), qd = JointState::Zero();

  std::cout.precision(2);
  std::cout << "HyL pulled to a posture\n";
  const double dt = 1e-3;
  for (int i = 0; i <= 1000; ++i) {
    if (i % 200 == 0) std::cout << "t = " << i * dt << " s: error [m, rad, rad] = " << (goal - q).transpose() << '\n';
    qd += dt * hyl::forward_dynamics(q, qd, control(q, qd, goal));
    q += dt * qd;
  }
  std::cout << '\n';
}
