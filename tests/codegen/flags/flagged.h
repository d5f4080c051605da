// Functions of a user's own file, which includes kernels and is compiled with flags that kernels must support.
#pragma once

namespace flagged {

constexpr int kLegJoints = 3;         // of robot hyl
constexpr int kLegsJoints = 12;       // of robot quadruped, whose legs are computed in lanes
constexpr int kLegsResults = 12 + 6;  // forces of its joints, and the acceleration of its base
constexpr int kAngles = 7;

template <class Scalar>
void inverse_dynamics_of_leg(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau);
template <class Scalar>
void forward_dynamics_of_leg(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd);
template <class Scalar>
void inverse_dynamics_of_legs(
    const Scalar* q,
    const Scalar* qd,
    const Scalar* qdd,
    const Scalar* base_velocity,
    const Scalar* gravity,
    Scalar* results);

// Sines and cosines of kAngles angles together, and of eight angles in lanes.
template <class Scalar>
void sines(const Scalar* q, Scalar* sine, Scalar* cosine);
template <class Scalar>
void sines_in_lanes(const Scalar* q, Scalar* sine, Scalar* cosine);

}  // namespace flagged
