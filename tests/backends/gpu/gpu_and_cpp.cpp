// The text for GPUs, called on the host with arrays and with accessors, gives the results of the library in C++.
#include <both/leg/leg.h>
#include <gpus_leg_gpu/gpus_leg_gpu.h>

#include <algorithm>
#include <cstdio>

int main() {
  using namespace both::leg;
  double worst = 0;
  for (int state = 0; state < 100; ++state) {
    const JointState q = JointState::Random() * 3, qd = JointState::Random(), qdd = JointState::Random();
    JointState tau;
    gpus_leg_gpu_inverse_dynamics<double>(q.data(), qd.data(), qdd.data(), tau.data());
    // Every second number of an array.
    double spaced[2 * kDof * kDof];
    gpus_leg_gpu_joint_space_inertia<double>(q.data(), robcogen::gpu::Strided<double>{spaced, 2});
    InertiaMatrix H;
    for (int k = 0; k < kDof * kDof; ++k) H.data()[k] = spaced[2 * k];
    worst = std::max({worst, (tau - inverse_dynamics(q, qd, qdd)).norm(), (H - joint_space_inertia(q)).norm()});
  }
  std::printf("largest difference %g\n", worst);
  return worst < 1e-12 && gpus_leg_gpu_dof == kDof ? 0 : 1;
}
