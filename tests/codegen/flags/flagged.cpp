// A user's own file: it includes headers of kernels, and is compiled with the user's flags.
#include "flagged.h"

#include "hyl/kernel/forward_dynamics.h"
#include "hyl/kernel/inverse_dynamics.h"
#include "quadruped/kernel/inverse_dynamics.h"
#include "robcogen/sincos_of.h"

namespace flagged {

template <class Scalar>
void inverse_dynamics_of_leg(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau) {
  hyl::kernel::inverse_dynamics(q, qd, qdd, tau);
}

template <class Scalar>
void forward_dynamics_of_leg(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd) {
  hyl::kernel::forward_dynamics(q, qd, tau, qdd);
}

template <class Scalar>
void inverse_dynamics_of_legs(
    const Scalar* q,
    const Scalar* qd,
    const Scalar* qdd,
    const Scalar* base_velocity,
    const Scalar* gravity,
    Scalar* results) {
  quadruped::kernel::inverse_dynamics(q, qd, qdd, base_velocity, gravity, results, results + kLegsJoints);
}

template <class Scalar>
void sines(const Scalar* q, Scalar* sine, Scalar* cosine) {
  robcogen::sincos_of<kAngles>(q, sine, cosine);
}

template <class Scalar>
void sines_in_lanes(const Scalar* q, Scalar* sine, Scalar* cosine) {
  const auto both = robcogen::sincos(robcogen::Lanes<Scalar, 8>::load(q));
  both.sin.store(sine);
  both.cos.store(cosine);
}

#define FLAGGED_INSTANTIATE(Scalar)                                                            \
  template void inverse_dynamics_of_leg(const Scalar*, const Scalar*, const Scalar*, Scalar*); \
  template void forward_dynamics_of_leg(const Scalar*, const Scalar*, const Scalar*, Scalar*); \
  template void inverse_dynamics_of_legs(                                                      \
      const Scalar*, const Scalar*, const Scalar*, const Scalar*, const Scalar*, Scalar*);     \
  template void sines(const Scalar*, Scalar*, Scalar*);                                        \
  template void sines_in_lanes(const Scalar*, Scalar*, Scalar*);

FLAGGED_INSTANTIATE(double)
FLAGGED_INSTANTIATE(float)

}  // namespace flagged
