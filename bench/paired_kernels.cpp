// The kernels of a generated library for AVX2 with a fixed base, under names that paired.cpp looks up.
#define ROBCOGEN_WITH_AVX2
#include <subject/kernels_avx2_1.cpp>
#include <subject/kernels_avx2_2.cpp>

namespace kernel = subject::kernel::avx2;

extern "C" void inverse_dynamics(const double* q, const double* qd, const double* qdd, double* tau) {
  kernel::inverse_dynamics<double>(q, qd, qdd, tau);
}
extern "C" void forward_dynamics(const double* q, const double* qd, const double* tau, double* qdd) {
  kernel::forward_dynamics<double>(q, qd, tau, qdd);
}
extern "C" void joint_space_inertia(const double* q, const double*, const double*, double* H) {
  kernel::joint_space_inertia<double>(q, H);
}
