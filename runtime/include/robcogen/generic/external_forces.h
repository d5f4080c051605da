// Forces of the environment on any robot, from the forces of its motors and without accelerations. Needs C++20.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <cassert>

#include "robcogen/generic/state.h"

namespace robcogen {

// Observes generalised forces by the momentum p = H v: the residual r = K (p - p(0) - integral of (tau + rate + r) dt)
// follows the forces of the environment with the time constant 1 / K in each coordinate, and no coordinate disturbs
// another (De Luca and Mattone, ICRA 2003; De Luca et al., IROS 2006).
//
//     ExternalForceObserver observer(robot, state, 50.0);          // 1/s
//     const auto& tau_external = observer.update(state, tau, dt);  // once in each cycle
template <HasControlTerms R>
class ROBCOGEN_ALIGNED ExternalForceObserver {
 public:
  using Scalar = typename R::Scalar;
  // N m, N: of the joints; with a floating base, behind the wrench on it, in base coordinates, angular first.
  using Forces = Matrix<Scalar, R::InertiaMatrix::RowsAtCompileTime, 1>;

  // `gain` K (1/s), positive. The observer keeps a reference to the robot.
  ExternalForceObserver(const R& robot, const State<R>& state, Scalar gain) noexcept : robot_(&robot), gain_(gain) {
    assert(gain > 0);
    reset(state);
  }
  ExternalForceObserver(const R&& robot, const State<R>& state, Scalar gain) = delete;

  // Begins again, without external forces.
  void reset(const State<R>& state) noexcept {
    const auto now = momentum(state);
    expected_ = now.p;
    rate_ = now.rate;
    residual_.setZero();
  }

  // The forces of the environment, after the motors have applied the joint forces `tau` (N m, N) for `dt` (s). The step
  // is implicit in the residual: stable for any gain and any dt.
  const Forces& update(const State<R>& state, const typename R::JointState& tau, Scalar dt) noexcept {
    const auto now = momentum(state);
    Forces change = Scalar(0.5) * (rate_ + now.rate);
    change.template tail<R::kDof>() += tau;
    expected_ += dt * change;
    residual_ = (gain_ / (Scalar(1) + gain_ * dt)) * (now.p - expected_);
    expected_ += dt * residual_;
    rate_ = now.rate;
    return residual_;
  }

  const Forces& forces() const noexcept { return residual_; }

 private:
  const R* robot_;
  Scalar gain_;
  Forces expected_, rate_, residual_;  // p(0) plus the integral; rate and residual at the last update

  auto momentum(const State<R>& state) const noexcept {
    if constexpr (R::kFloatingBase) {
      return robot_->generalized_momentum(state.q, state.qd, state.base_velocity, gravity_in_base(state));
    } else {
      return robot_->generalized_momentum(state.q, state.qd);
    }
  }
};

}  // namespace robcogen

#else
#error "robcogen/generic/external_forces.h needs C++20: compile with -std=c++20"
#endif
