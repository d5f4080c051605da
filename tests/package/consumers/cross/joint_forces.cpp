// Reads positions, velocities, accelerations and forces; prints the largest difference between these forces and the
// forces computed here, in limbs that share lanes.
#include <quadruped/quadruped.h>

#include <cstdio>

int main() {
  quadruped::JointState state[4];
  for (quadruped::JointState& s : state)
    for (int k = 0; k < quadruped::kDof; ++k)
      if (std::scanf("%lf", &s[k]) != 1) return 2;
  const quadruped::JointState tau = quadruped::inverse_dynamics(state[0], state[1], state[2]);
  const double error = (tau - state[3]).cwiseAbs().maxCoeff() / state[3].cwiseAbs().maxCoeff();
  std::printf("error %g\n", error);
  return error < 1e-13 ? 0 : 1;
}
