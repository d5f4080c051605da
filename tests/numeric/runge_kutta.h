// A fourth-order time step.
#pragma once

#include "robcogen/reference/kinematics.h"

namespace robcogen::numeric {

// Advances q and qd by `h` seconds; `acceleration(q, qd)` returns one element per coordinate.
template <class Acceleration>
void runge_kutta_step(
    double h,
    const Acceleration& acceleration,
    reference::Vector<double>& q,
    reference::Vector<double>& qd) {
  using Vector = reference::Vector<double>;
  const Vector v1 = qd, a1 = acceleration(q, v1);
  const Vector v2 = qd + h / 2 * a1, a2 = acceleration(q + h / 2 * v1, v2);
  const Vector v3 = qd + h / 2 * a2, a3 = acceleration(q + h / 2 * v2, v3);
  const Vector v4 = qd + h * a3, a4 = acceleration(q + h * v3, v4);
  q = q + h / 6 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
  qd = qd + h / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
}

}  // namespace robcogen::numeric
