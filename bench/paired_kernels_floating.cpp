// The kernels of paired_kernels.cpp for a robot with a floating base, whose coordinates follow those of the joints:
// twist and spatial acceleration in the arguments, wrench or spatial acceleration in the results.
#define ROBCOGEN_WITH_AVX2
#include <subject/kernels_avx2_1.cpp>
#include <subject/kernels_avx2_2.cpp>

#include <subject/model.h>

namespace kernel = subject::kernel::avx2;
using subject::kDof;

namespace {
constexpr double kGravity[] = {0, 0, -9.81};
}

extern "C" void inverse_dynamics(const double* q, const double* qd, const double* qdd, double* tau) {
  kernel::inverse_dynamics_fully_actuated<double>(q, qd, qdd, qd + kDof, qdd + kDof, kGravity, tau, tau + kDof);
}
extern "C" void forward_dynamics(const double* q, const double* qd, const double* tau, double* qdd) {
  kernel::forward_dynamics<double>(q, qd, tau, qd + kDof, kGravity, qdd, qdd + kDof);
}
extern "C" void joint_space_inertia(const double* q, const double*, const double*, double* H) {
  kernel::joint_space_inertia<double>(q, H);
}
