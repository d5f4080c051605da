// The functions of a robot behind an interface that all robots share. Needs C++20.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <Eigen/Core>

#include "robcogen/concepts.h"
#include "robcogen/joint_limits.h"
#include "robcogen/matrix.h"

namespace robcogen::any {

// The functions of each robot, on plain arrays of the right sizes. `external` may be null.
class Functions {
 public:
  virtual ~Functions() = default;
  struct Loads {
    const Gravity& gravity;
    const Wrench* external;
  };
  virtual SpatialAcceleration inverse_dynamics(
      const double* q,
      const double* v,
      const double* qdd,
      double* tau,
      const Loads& loads) const noexcept = 0;
  virtual void inverse_dynamics_fully_actuated(
      const double* q,
      const double* v,
      const double* a,
      double* f,
      const Loads& loads) const noexcept = 0;
  virtual void forward_dynamics(const double* q, const double* v, const double* tau, double* a, const Loads& loads)
      const noexcept = 0;
  virtual void bias_forces(const double* q, const double* v, double* f, const Loads& loads) const noexcept = 0;
  virtual void gravity_forces(const double* q, double* f, const Gravity& gravity) const noexcept = 0;
  virtual void coriolis_forces(const double* q, const double* v, double* f) const noexcept = 0;
  virtual void joint_space_inertia(const double* q, Eigen::Ref<DynamicMatrix<double>> H) const noexcept = 0;
  // The first input of kernels of a robot with parameters; otherwise null.
  virtual const double* cache() const noexcept = 0;
  virtual const JointLimits* joint_limits() const noexcept = 0;
};

template <class R>
class FunctionsOf final : public Functions {
 public:
  explicit FunctionsOf(const R& robot) : robot_(robot) {}

  SpatialAcceleration inverse_dynamics(
      const double* q,
      const double* v,
      const double* qdd,
      double* tau,
      const Loads& loads) const noexcept override {
    return with(loads, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        const auto result = robot_.inverse_dynamics(positions(q), qd_of(v), joints(qdd), Twist(base(v)), extra...);
        Eigen::Map<JointState>{tau} = result.tau;
        return result.base_acceleration;
      } else {
        Eigen::Map<JointState>{tau} = robot_.inverse_dynamics(positions(q), qd_of(v), joints(qdd), extra...);
        return SpatialAcceleration();
      }
    });
  }
  void inverse_dynamics_fully_actuated(const double* q, const double* v, const double* a, double* f, const Loads& loads)
      const noexcept override {
    with(loads, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        set_forces(
            f, robot_.inverse_dynamics_fully_actuated(
                   positions(q), qd_of(v), qd_of(a), Twist(base(v)), SpatialAcceleration(base(a)), extra...));
      } else {
        set_forces(f, robot_.inverse_dynamics(positions(q), joints(v), joints(a), extra...));
      }
    });
  }
  void forward_dynamics(const double* q, const double* v, const double* tau, double* a, const Loads& loads)
      const noexcept override {
    with(loads, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        const auto result = robot_.forward_dynamics(positions(q), qd_of(v), joints(tau), Twist(base(v)), extra...);
        Eigen::Map<Vector6>{a} = result.base_acceleration.vector();
        Eigen::Map<JointState>{a + 6} = result.qdd;
      } else {
        Eigen::Map<JointState>{a} = robot_.forward_dynamics(positions(q), joints(v), joints(tau), extra...);
      }
    });
  }
  void bias_forces(const double* q, const double* v, double* f, const Loads& loads) const noexcept override {
    with(loads, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        set_forces(f, robot_.bias_forces(positions(q), qd_of(v), Twist(base(v)), extra...));
      } else {
        set_forces(f, robot_.bias_forces(positions(q), joints(v), extra...));
      }
    });
  }
  void gravity_forces(const double* q, double* f, const Gravity& gravity) const noexcept override {
    set_forces(f, robot_.gravity_forces(positions(q), gravity));
  }
  void coriolis_forces(const double* q, const double* v, double* f) const noexcept override {
    if constexpr (R::kFloatingBase) {
      set_forces(f, robot_.coriolis_forces(positions(q), qd_of(v), Twist(base(v))));
    } else {
      set_forces(f, robot_.coriolis_forces(positions(q), joints(v)));
    }
  }
  void joint_space_inertia(const double* q, Eigen::Ref<DynamicMatrix<double>> H) const noexcept override {
    H = robot_.joint_space_inertia(positions(q));
  }
  const JointLimits* joint_limits() const noexcept override { return R::kJointLimits.data(); }
  const double* cache() const noexcept override {
    if constexpr (requires { robot_.parameters.data(); }) {
      return robot_.parameters.data();
    } else {
      return nullptr;
    }
  }

 private:
  using JointState = typename R::JointState;
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  static JointPositions<R> positions(const double* q) noexcept { return Eigen::Map<const JointPositions<R>>(q); }
  static JointState joints(const double* v) noexcept { return Eigen::Map<const JointState>(v); }
  static JointState qd_of(const double* v) noexcept { return joints(v + (R::kFloatingBase ? 6 : 0)); }
  static Eigen::Map<const Vector6> base(const double* v) noexcept { return Eigen::Map<const Vector6>(v); }

  template <class Forces>
  static void set_forces(double* f, const Forces& forces) noexcept {
    if constexpr (R::kFloatingBase) {
      Eigen::Map<Vector6>{f} = forces.base_wrench.vector();
      Eigen::Map<JointState>{f + 6} = forces.tau;
    } else {
      Eigen::Map<JointState>{f} = forces;
    }
  }

  // Calls the overload that takes these loads.
  template <class Call>
  static auto with(const Loads& loads, const Call& call) noexcept {
    if (loads.external == nullptr) return call(loads.gravity);
    typename R::LinkWrenches wrenches;
    for (int i = 0; i < R::kLinkCount; ++i) wrenches[i] = loads.external[i];
    return call(loads.gravity, wrenches);
  }

  R robot_;
};

}  // namespace robcogen::any

#else
#error "robcogen/any/functions.h needs C++20: compile with -std=c++20"
#endif
