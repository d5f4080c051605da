// A generated library as the subject of checks. `R` is the library's `Robot`, in double or in single precision; include
// its header first. A robot with parameters carries their values.
#pragma once

#include <type_traits>
#include <vector>

#include "robcogen/link_wrenches.h"
#include "robcogen/positions.h"
#include "robcogen/reference/check_factor.h"
#include "robcogen/reference/subject.h"

namespace robcogen::reference {

template <class R, class = void>
inline constexpr bool kIsParametric = false;
template <class R>
inline constexpr bool kIsParametric<R, std::void_t<typename R::Parameters>> = true;

// The first input of the kernels of a robot with parameters; otherwise nullptr.
template <class R>
const double* cache_of([[maybe_unused]] const R& robot) {
  if constexpr (kIsParametric<R>) {
    return robot.parameters.data();
  } else {
    return nullptr;
  }
}

template <class R>
class CompiledRobot {
 public:
  using State = Motion<double>;
  using Scalar = typename R::Scalar;

  explicit CompiledRobot(const Robot& tables, const R& robot = R()) : tables_(&tables), robot_(robot) {}

  // The first input of the kernels; empty if the robot has no parameters.
  std::vector<double> cache() const {
    if constexpr (kIsParametric<R>) {
      return {robot_.parameters.data(), robot_.parameters.data() + R::Parameters::size()};
    } else {
      return {};
    }
  }

  // (base acceleration, tau): the library's results for a given qdd.
  Vector<double> inverse_dynamics(const State& m, const Arguments& arguments) const {
    return with(arguments, [&](const auto&... extra) {
      const JointPositions q = positions(m.q);
      const JointState qd = joints(m.qd), qdd = joints(m.qdd);
      if constexpr (R::kFloatingBase) {
        const auto result = robot_.inverse_dynamics(q, qd, qdd, spatial<BasicTwist<Scalar>>(m.base_velocity), extra...);
        return stacked(vector(result.base_acceleration.vector()), vector(result.tau));
      } else {
        return vector(robot_.inverse_dynamics(q, qd, qdd, extra...));
      }
    });
  }

  // (base wrench, tau), for a given base acceleration, too.
  Vector<double> inverse_dynamics_fully_actuated(const State& m, const Arguments& arguments) const {
    if constexpr (R::kFloatingBase) {
      return with(arguments, [&](const auto&... extra) {
        const auto result = robot_.inverse_dynamics_fully_actuated(
            positions(m.q), joints(m.qd), joints(m.qdd), spatial<BasicTwist<Scalar>>(m.base_velocity),
            spatial<BasicSpatialAcceleration<Scalar>>(m.base_acceleration), extra...);
        return stacked(vector(result.base_wrench.vector()), vector(result.tau));
      });
    } else {
      return inverse_dynamics(m, arguments);
    }
  }

  // (base acceleration, qdd).
  Vector<double> forward_dynamics(const State& m, const Vector<double>& tau, const Arguments& arguments) const {
    return with(arguments, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        const auto result = robot_.forward_dynamics(
            positions(m.q), joints(m.qd), joints(tau), spatial<BasicTwist<Scalar>>(m.base_velocity), extra...);
        return stacked(vector(result.base_acceleration.vector()), vector(result.qdd));
      } else {
        return vector(robot_.forward_dynamics(positions(m.q), joints(m.qd), joints(tau), extra...));
      }
    });
  }

  // (base wrench, tau).
  Vector<double> bias_forces(const State& m, const Arguments& arguments) const {
    return with(arguments, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        return forces(
            robot_.bias_forces(positions(m.q), joints(m.qd), spatial<BasicTwist<Scalar>>(m.base_velocity), extra...));
      } else {
        return forces(robot_.bias_forces(positions(m.q), joints(m.qd), extra...));
      }
    });
  }

  // (base wrench, tau); `external` is ignored.
  Vector<double> gravity_forces(const Vector<double>& q, const Arguments& arguments) const {
    return with_gravity(arguments, [&](const auto&... g) { return forces(robot_.gravity_forces(positions(q), g...)); });
  }

  // (base wrench, tau).
  Vector<double> coriolis_forces(const State& m) const {
    if constexpr (R::kFloatingBase) {
      return forces(robot_.coriolis_forces(positions(m.q), joints(m.qd), spatial<BasicTwist<Scalar>>(m.base_velocity)));
    } else {
      return forces(robot_.coriolis_forces(positions(m.q), joints(m.qd)));
    }
  }

  Vector<double> passive_forces(const State& m) const {
    return vector(robot_.passive_forces(positions(m.q), joints(m.qd)));
  }

  Matrix<double> joint_space_inertia(const Vector<double>& q) const {
    return matrix(robot_.joint_space_inertia(positions(q)));
  }

  FactorResults inertia_factor(const Vector<double>& q, const Vector<double>& x) const {
    const auto factor = robot_.joint_space_inertia_factor(positions(q));
    std::decay_t<decltype(factor.inverse_diagonal())> right;
    std::copy(x.data(), x.data() + x.rows(), right.data());
    return {matrix(factor.L()), matrix(factor.inverse_L()), matrix(factor.inverse()), vector(factor.solve(right))};
  }

  // Multiplies (base twist, qd), like H.
  Matrix<double> coriolis_matrix(const State& m) const {
    if constexpr (R::kFloatingBase) {
      return matrix(robot_.coriolis_matrix(positions(m.q), joints(m.qd), spatial<BasicTwist<Scalar>>(m.base_velocity)));
    } else {
      return matrix(robot_.coriolis_matrix(positions(m.q), joints(m.qd)));
    }
  }

  // `external` is ignored.
  MomentumAndRate generalized_momentum(const State& m, const Arguments& arguments) const {
    return with_gravity(arguments, [&](const auto&... g) -> MomentumAndRate {
      if constexpr (R::kFloatingBase) {
        const auto result = robot_.generalized_momentum(
            positions(m.q), joints(m.qd), spatial<BasicTwist<Scalar>>(m.base_velocity), g...);
        return {vector(result.p), vector(result.rate)};
      } else {
        const auto result = robot_.generalized_momentum(positions(m.q), joints(m.qd), g...);
        return {vector(result.p), vector(result.rate)};
      }
    });
  }

  PathTerms path_dynamics(const State& m, const Arguments& arguments) const {
    return with_gravity(arguments, [&](const auto&... g) -> PathTerms {
      const auto result = robot_.path_dynamics(positions(m.q), joints(m.qd), joints(m.qdd), g...);
      return {vector(result.a), vector(result.b), vector(result.c)};
    });
  }

  // Derivatives of (base wrench, tau), or of tau with a fixed base.
  Derivatives inverse_dynamics_fully_actuated_derivatives(const State& m, const Arguments& arguments) const {
    return with(arguments, [&](const auto&... extra) {
      const JointPositions q = positions(m.q);
      const JointState qd = joints(m.qd), qdd = joints(m.qdd);
      if constexpr (R::kFloatingBase) {
        const auto d = robot_.inverse_dynamics_fully_actuated_derivatives(
            q, qd, qdd, spatial<BasicTwist<Scalar>>(m.base_velocity),
            spatial<BasicSpatialAcceleration<Scalar>>(m.base_acceleration), extra...);
        Derivatives result = derivatives(d, stacked(vector(d.base_wrench.vector()), vector(d.tau)), d.d_qdd);
        result.base_acceleration = matrix(d.d_base_acceleration);
        return result;
      } else {
        const auto d = robot_.inverse_dynamics_derivatives(q, qd, qdd, extra...);
        return derivatives(d, vector(d.tau), d.d_qdd);
      }
    });
  }

  // Derivatives of (base acceleration, tau).
  Derivatives inverse_dynamics_derivatives(const State& m, const Arguments& arguments) const {
    return with(arguments, [&](const auto&... extra) {
      const auto d = robot_.inverse_dynamics_derivatives(
          positions(m.q), joints(m.qd), joints(m.qdd), spatial<BasicTwist<Scalar>>(m.base_velocity), extra...);
      return derivatives(d, stacked(vector(d.base_acceleration.vector()), vector(d.tau)), d.d_qdd);
    });
  }

  // Derivatives of (base acceleration, qdd), or of qdd with a fixed base.
  Derivatives forward_dynamics_derivatives(const State& m, const Vector<double>& tau, const Arguments& arguments)
      const {
    return with(arguments, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        const auto d = robot_.forward_dynamics_derivatives(
            positions(m.q), joints(m.qd), joints(tau), spatial<BasicTwist<Scalar>>(m.base_velocity), extra...);
        return derivatives(d, stacked(vector(d.base_acceleration.vector()), vector(d.qdd)), d.d_tau);
      } else {
        const auto d = robot_.forward_dynamics_derivatives(positions(m.q), joints(m.qd), joints(tau), extra...);
        return derivatives(d, vector(d.qdd), d.d_tau);
      }
    });
  }

  // Derivatives of weights times (base wrench, tau), as columns.
  Derivatives inverse_dynamics_gradient(const State& m, const Vector<double>& weights, const Arguments& arguments)
      const {
    return with(arguments, [&](const auto&... extra) {
      Eigen::Matrix<Scalar, R::InertiaMatrix::RowsAtCompileTime, 1> w;
      for (int i = 0; i < weights.rows(); ++i) w[i] = static_cast<Scalar>(weights(i));
      const JointPositions q = positions(m.q);
      const JointState qd = joints(m.qd), qdd = joints(m.qdd);
      if constexpr (R::kFloatingBase) {
        const auto d = robot_.inverse_dynamics_gradient(
            q, qd, qdd, spatial<BasicTwist<Scalar>>(m.base_velocity),
            spatial<BasicSpatialAcceleration<Scalar>>(m.base_acceleration), w, extra...);
        return Derivatives{
            stacked(vector(d.base_wrench.vector()), vector(d.tau)),
            vector(d.d_q),
            vector(d.d_qd),
            vector(d.d_qdd),
            {},
            vector(d.d_base_velocity),
            vector(d.d_base_acceleration)};
      } else {
        const auto d = robot_.inverse_dynamics_gradient(q, qd, qdd, w, extra...);
        return Derivatives{vector(d.tau), vector(d.d_q), vector(d.d_qd), vector(d.d_qdd), {}, {}, {}};
      }
    });
  }

  // Only the blocks q and base_rotation; `external` is ignored.
  Derivatives gravity_forces_derivative(const Vector<double>& q, const Arguments& arguments) const {
    return with_gravity(arguments, [&](const auto&... g) {
      const auto d = robot_.gravity_forces_derivative(positions(q), g...);
      Derivatives result;
      if constexpr (R::kFloatingBase) {
        result.q = matrix(d.d_q);
        result.base_rotation = matrix(d.d_base_rotation);
      } else {
        result.q = matrix(d);
      }
      return result;
    });
  }

  Matrix<double> regressor(const State& m, const Arguments& arguments) const {
    return with_gravity(arguments, [&](const auto&... g) {
      return of_motion(m, [&](const auto&... state) { return robot_.regressor(state..., g...); });
    });
  }
  Matrix<double> drive_regressor(const State& m) const {
    return of_motion(m, [&](const auto&... state) { return robot_.drive_regressor(state...); });
  }
  Vector<double> inertial_parameters() const { return vector(robot_.inertial_parameters()); }
  Vector<double> drive_parameters() const { return vector(robot_.drive_parameters()); }

  // With a fixed base and gravity as an argument, the regressor for any gravity.
  Matrix<double> base_regressor(const State& m, const Arguments& arguments) const {
    return with_gravity(arguments, [&](const auto&... g) {
      return of_motion(m, [&](const auto&... state) {
        // Two conditions: clang 14 does not know sizeof...(g) yet where it looks for members.
        if constexpr (R::kFloatingBase) {
          return robot_.base_regressor(state..., g...);
        } else if constexpr (sizeof...(g) == 0) {
          return robot_.base_regressor(state...);
        } else {
          return robot_.base_regressor_any_gravity(state..., g...);
        }
      });
    });
  }
  Vector<double> base_parameters(const Vector<double>& inertial_parameters, [[maybe_unused]] const Arguments& arguments)
      const {
    constexpr int kMoving = R::kLinkCount - (R::kFloatingBase ? 0 : 1);
    Eigen::Matrix<Scalar, 10 * kMoving, 1> all;
    for (int i = 0; i < inertial_parameters.rows(); ++i) all[i] = static_cast<Scalar>(inertial_parameters(i));
    if constexpr (!R::kFloatingBase) {
      if (arguments.gravity != nullptr) return vector(robot_.base_parameters_any_gravity(all));
    }
    return vector(robot_.base_parameters(all));
  }

  Matrix<double> energy_regressor(const State& m, const Arguments& arguments) const {
    return with_gravity(arguments, [&](const auto&... g) {
      if constexpr (R::kFloatingBase) {
        return matrix(
            robot_.energy_regressor(positions(m.q), joints(m.qd), spatial<BasicTwist<Scalar>>(m.base_velocity), g...));
      } else {
        return matrix(robot_.energy_regressor(positions(m.q), joints(m.qd), g...));
      }
    });
  }

  // `r` holds the reference velocities and accelerations.
  Matrix<double> slotine_li_regressor(const State& m, const State& r, const Arguments& arguments) const {
    return with_gravity(arguments, [&](const auto&... g) {
      const JointPositions q = positions(m.q);
      const JointState qd = joints(m.qd), qd_r = joints(r.qd), qdd_r = joints(r.qdd);
      if constexpr (R::kFloatingBase) {
        return matrix(robot_.slotine_li_regressor(
            q, qd, qd_r, qdd_r, spatial<BasicTwist<Scalar>>(m.base_velocity),
            spatial<BasicTwist<Scalar>>(r.base_velocity),
            spatial<BasicSpatialAcceleration<Scalar>>(r.base_acceleration), g...));
      } else {
        return matrix(robot_.slotine_li_regressor(q, qd, qd_r, qdd_r, g...));
      }
    });
  }

  // For robots with parameters; for others it is a constant.
  double total_mass() const { return robot_.total_mass(); }
  Vector<double> center_of_mass(const Vector<double>& q) const { return vector(robot_.center_of_mass(positions(q))); }
  Matrix<double> center_of_mass_jacobian(const Vector<double>& q) const {
    return matrix(robot_.center_of_mass_jacobian(positions(q)));
  }
  Matrix<double> centroidal_momentum_matrix(const Vector<double>& q) const {
    return matrix(robot_.centroidal_momentum_matrix(positions(q)));
  }

  double kinetic_energy(const State& m) const {
    if constexpr (R::kFloatingBase) {
      return robot_.kinetic_energy(positions(m.q), joints(m.qd), spatial<BasicTwist<Scalar>>(m.base_velocity));
    } else {
      return robot_.kinetic_energy(positions(m.q), joints(m.qd));
    }
  }
  // `external` is ignored.
  double potential_energy(const Vector<double>& q, const Arguments& arguments) const {
    return with_gravity(arguments, [&](const auto&... g) { return robot_.potential_energy(positions(q), g...); });
  }

  // `index` refers to the tables.
  TransformForms transform(int index, const Vector<double>& q) const {
    const reflection::Transform& kernels = tables_->transforms[index];
    // As the library's own functions do: the kernels write the matrices that they return.
    typename R::template Matrix<4, 4> homogeneous;
    typename R::template Matrix<6, 6> motion, force;
    kernels.homogeneous(cache_of(robot_), q.data(), homogeneous.data());
    kernels.motion(cache_of(robot_), q.data(), motion.data());
    kernels.force(cache_of(robot_), q.data(), force.data());
    return {matrix(homogeneous), matrix(motion), matrix(force)};
  }

  Matrix<double> jacobian(int index, const Vector<double>& q) const {
    const reflection::Jacobian& what = tables_->jacobians[index];
    typename R::template Matrix<6, Eigen::Dynamic> J(6, what.column_count);
    what.kernel(cache_of(robot_), q.data(), J.data());
    return matrix(J);
  }

  // 6 x FrameFunction::column_count.
  Matrix<double> frame_function(int index, const State& m) const {
    const reflection::FrameFunction& f = tables_->frame_functions[index];
    std::vector<double> inputs;
    if constexpr (kIsParametric<R>) inputs.assign(cache_of(robot_), cache_of(robot_) + R::Parameters::size());
    for (const Vector<double>* v : {&m.q, &m.qd, &m.qdd}) inputs.insert(inputs.end(), v->data(), v->data() + v->rows());
    typename R::template Matrix<6, Eigen::Dynamic> result(6, f.column_count);
    f.call(inputs.data(), result.data());
    return matrix(result);
  }

 private:
  using JointState = typename R::JointState;
  using JointPositions = robcogen::JointPositions<R>;

  static JointPositions positions(const Vector<double>& q) {
    JointPositions result;
    for (int i = 0; i < q.rows(); ++i) result.data()[i] = static_cast<Scalar>(q(i));
    return result;
  }
  static JointState joints(const Vector<double>& v) {
    JointState result;
    for (int i = 0; i < v.rows(); ++i) result.data()[i] = static_cast<Scalar>(v(i));
    return result;
  }

  template <class Spatial>
  static Spatial spatial(const Vector<double>& v) {
    Spatial result;
    for (int i = 0; i < 6; ++i) result.data()[i] = static_cast<Scalar>(v(i));
    return result;
  }

  static BasicGravity<Scalar> gravity(const Vector<double>& g) {
    return BasicGravity<Scalar>(static_cast<Scalar>(g(0)), static_cast<Scalar>(g(1)), static_cast<Scalar>(g(2)));
  }

  // Each robot has its own enumeration of links; here they are numbered.
  template <class Link, int kLinkCount>
  static void assign(LinkWrenches<Scalar, Link, kLinkCount>& to, const std::vector<Vector<double>>& from) {
    for (std::size_t i = 0; i < from.size(); ++i) to[static_cast<Link>(i)] = spatial<BasicWrench<Scalar>>(from[i]);
  }

  // Elements are read by their indices, as a user reads them, so that a wrong storage order is found.
  template <class EigenVector>
  static Vector<double> vector(const EigenVector& v) {
    Vector<double> result(static_cast<int>(v.size()));
    for (int i = 0; i < result.rows(); ++i) result(i) = static_cast<double>(v(i));
    return result;
  }

  template <class EigenMatrix>
  static Matrix<double> matrix(const EigenMatrix& m) {
    Matrix<double> result(static_cast<int>(m.rows()), static_cast<int>(m.cols()));
    for (int i = 0; i < result.rows(); ++i)
      for (int j = 0; j < result.cols(); ++j) result(i, j) = static_cast<double>(m(i, j));
    return result;
  }

  template <class Result, class Last>
  static Derivatives derivatives(const Result& d, const Vector<double>& value, const Last& last) {
    Derivatives result{value, matrix(d.d_q), matrix(d.d_qd), matrix(last), {}, {}, {}};
    if constexpr (R::kFloatingBase) {
      result.base_rotation = matrix(d.d_base_rotation);
      result.base_velocity = matrix(d.d_base_velocity);
    }
    return result;
  }

  template <class Result>
  static Vector<double> forces(const Result& result) {
    if constexpr (R::kFloatingBase) {
      return stacked(vector(result.base_wrench.vector()), vector(result.tau));
    } else {
      return vector(result);
    }
  }

  // Calls a function of the whole motion.
  template <class Call>
  static Matrix<double> of_motion(const State& m, const Call& call) {
    const JointPositions q = positions(m.q);
    const JointState qd = joints(m.qd), qdd = joints(m.qdd);
    if constexpr (R::kFloatingBase) {
      return matrix(call(
          q, qd, qdd, spatial<BasicTwist<Scalar>>(m.base_velocity),
          spatial<BasicSpatialAcceleration<Scalar>>(m.base_acceleration)));
    } else {
      return matrix(call(q, qd, qdd));
    }
  }

  // Calls the overload that takes these arguments.
  template <class Call>
  static auto with(const Arguments& arguments, const Call& call) {
    typename R::LinkWrenches wrenches;
    if (arguments.external != nullptr) assign(wrenches, *arguments.external);
    return with_gravity(
        arguments, [&](const auto&... g) { return arguments.external == nullptr ? call(g...) : call(g..., wrenches); });
  }

  // Without a gravity argument, standard gravity applies: with a fixed base through the overload without gravity.
  template <class Call>
  static auto with_gravity(const Arguments& arguments, const Call& call) {
    if (arguments.gravity != nullptr) return call(gravity(*arguments.gravity));
    if constexpr (R::kFloatingBase) {
      return call(BasicGravity<Scalar>::standard());
    } else {
      return call();
    }
  }

  const Robot* tables_;
  R robot_;
};

}  // namespace robcogen::reference
