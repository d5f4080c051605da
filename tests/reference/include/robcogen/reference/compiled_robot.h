// One way to call the generated functions of fixed-base and floating-base robots: vectors of run-time size, the base's
// six coordinates first where the base floats. `R` is a generated library's `Robot`; include its header before.
#pragma once

#include <vector>

#include "robcogen/link_wrenches.h"
#include "robcogen/reference/dynamics.h"

namespace robcogen::reference {

// (base, joints) for a floating base, else the joints alone.
template <class Scalar>
VectorX<Scalar> coordinates(bool floating, const Vector6<Scalar>& base, const VectorX<Scalar>& joints) {
  if (!floating) return joints;
  VectorX<Scalar> all(6 + joints.size());
  all << base, joints;
  return all;
}

// Links are indexed by each robot's own enumeration; here by number.
template <class Link, int kLinkCount>
void assign(LinkWrenches<double, Link, kLinkCount>& to, const std::vector<Vector6<double>>& from) {
  for (std::size_t i = 0; i < from.size(); ++i) to[static_cast<Link>(i)] = Wrench(from[i]);
}

template <class R>
struct CompiledRobot {
  using Vector = VectorX<double>;
  using State = Motion<double>;

  // The optional last arguments of the generated functions: gravity, link wrenches, both or neither.
  static Gravity gravity(const Vector3<double>& g) { return Gravity(g); }
  static typename R::LinkWrenches wrenches(const std::vector<Vector6<double>>& external) {
    typename R::LinkWrenches result;
    assign(result, external);
    return result;
  }

  // (base acceleration, tau): what the library finds, given qdd.
  template <class... Extra>
  static Vector inverse_dynamics(const State& m, const Extra&... extra) {
    if constexpr (R::kFloatingBase) {
      const auto result = R::inverse_dynamics(m.q, m.qd, m.qdd, Twist(m.base_velocity), extra...);
      return stacked(result.base_acceleration.vector(), result.tau);
    } else {
      return R::inverse_dynamics(m.q, m.qd, m.qdd, extra...);
    }
  }

  // (base wrench, tau), given the base acceleration too.
  template <class... Extra>
  static Vector fully_actuated(const State& m, const Extra&... extra) {
    if constexpr (R::kFloatingBase) {
      const auto result = R::inverse_dynamics_fully_actuated(
          m.q, m.qd, m.qdd, Twist(m.base_velocity), SpatialAcceleration(m.base_acceleration), extra...);
      return stacked(result.base_wrench.vector(), result.tau);
    } else {
      return R::inverse_dynamics(m.q, m.qd, m.qdd, extra...);
    }
  }

  // (base acceleration, qdd).
  template <class... Extra>
  static Vector forward_dynamics(const State& m, const Vector& tau, const Extra&... extra) {
    if constexpr (R::kFloatingBase) {
      const auto result = R::forward_dynamics(m.q, m.qd, tau, Twist(m.base_velocity), extra...);
      return stacked(result.base_acceleration.vector(), result.qdd);
    } else {
      return R::forward_dynamics(m.q, m.qd, tau, extra...);
    }
  }

  // (base wrench, tau).
  template <class... Extra>
  static Vector bias_forces(const State& m, const Extra&... extra) {
    if constexpr (R::kFloatingBase) {
      const auto result = R::bias_forces(m.q, m.qd, Twist(m.base_velocity), extra...);
      return stacked(result.base_wrench.vector(), result.tau);
    } else {
      return R::bias_forces(m.q, m.qd, extra...);
    }
  }

  template <class... Extra>
  static Vector gravity_forces(const State& m, const Extra&... extra) {
    const auto result = R::gravity_forces(m.q, extra...);
    if constexpr (R::kFloatingBase) {
      return stacked(result.base_wrench.vector(), result.tau);
    } else {
      return result;
    }
  }

  static Vector coriolis_forces(const State& m) {
    if constexpr (R::kFloatingBase) {
      const auto result = R::coriolis_forces(m.q, m.qd, Twist(m.base_velocity));
      return stacked(result.base_wrench.vector(), result.tau);
    } else {
      return R::coriolis_forces(m.q, m.qd);
    }
  }

  static MatrixX<double> joint_space_inertia(const Vector& q) { return R::joint_space_inertia(q); }

 private:
  static Vector stacked(const Vector6<double>& base, const Vector& joints) { return coordinates(true, base, joints); }
};

}  // namespace robcogen::reference
