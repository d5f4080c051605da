// Kernels in float only: the object file has no double-precision code.
#include "hyl/kernel/forward_dynamics.h"
#include "quadruped/kernel/inverse_dynamics.h"
#include "robcogen/sincos_of.h"

namespace single {

void forward_dynamics_of_leg(const float* q, const float* qd, const float* tau, float* qdd) {
  hyl::kernel::forward_dynamics(q, qd, tau, qdd);
}

void inverse_dynamics_of_legs(
    const float* q,
    const float* qd,
    const float* qdd,
    const float* base_velocity,
    const float* gravity,
    float* tau,
    float* base_acceleration) {
  quadruped::kernel::inverse_dynamics(q, qd, qdd, base_velocity, gravity, tau, base_acceleration);
}

void sines_of_seven(const float* q, float* sine, float* cosine) {
  robcogen::sincos_of<7>(q, sine, cosine);
}

void sines_of_two(const float* q, float* sine, float* cosine) {
  robcogen::sincos_of<2>(q, sine, cosine);
}

void sines_in_two_lanes(const float* q, float* sine, float* cosine) {
  const auto both = robcogen::sincos(robcogen::Lanes<float, 2>::load(q));
  both.sin.store(sine);
  both.cos.store(cosine);
}

}  // namespace single
