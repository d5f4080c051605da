// A user's program: forward dynamics recovers the acceleration from the forces that inverse dynamics computes.
#include <hyl/hyl.h>

#include <cstdio>

int main() {
  const hyl::JointState q(0.1, 0.4, -0.9);
  const hyl::JointState qd(0.5, -1.0, 2.0);
  const hyl::JointState qdd(1.0, 2.0, -3.0);
  const hyl::JointState tau = hyl::inverse_dynamics(q, qd, qdd);
  const double error = (hyl::forward_dynamics(q, qd, tau) - qdd).cwiseAbs().maxCoeff();
  std::printf("tau = %g %g %g, error %g\n", tau[0], tau[1], tau[2], error);
  return error < 1e-9 ? 0 : 1;
}
