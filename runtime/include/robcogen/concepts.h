// Concepts for code that is generic over robots: requirements on the type `Robot` of a generated library. Needs C++20.
//
//     template <robcogen::FixedBaseRobot R>
//     void control(const R& robot, …);
//     control(hyl::Robot(), …);
//
// The functions are members of a value: a robot with parameters carries their values, a robot without parameters is
// empty. A library that was generated with fewer algorithms satisfies the finer concepts of the algorithms it has.
// Positions q are JointPositions<R> (positions.h): with spherical joints they have more elements than velocities qd.
// Transforms and Jacobians have different names in each library and are not part of the concepts; see
// robcogen/generic/inverse_kinematics.h for how generic code receives them.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <Eigen/Core>
#include <concepts>
#include <type_traits>
#include <utility>

#include "robcogen/matrix.h"
#include "robcogen/positions.h"
#include "robcogen/results.h"
#include "robcogen/spatial.h"

namespace robcogen {

// Sizes and types that every robot has.
template <class R>
concept RobotTraits = requires {
  { R::kDof } -> std::convertible_to<int>;
  { R::kLinkCount } -> std::convertible_to<int>;
  { R::kFloatingBase } -> std::convertible_to<bool>;
  requires(kPositionCount<R> == R::kDof + static_cast<int>(kQuaternions<R>.size()));
  requires std::floating_point<typename R::Scalar>;
  requires std::same_as<typename R::JointState, Matrix<typename R::Scalar, R::kDof, 1>>;
  requires R::InertiaMatrix::RowsAtCompileTime == R::kDof + (R::kFloatingBase ? 6 : 0);
  requires std::same_as<typename R::Gravity, BasicGravity<typename R::Scalar>>;
  requires std::same_as<typename R::Twist, BasicTwist<typename R::Scalar>>;
  typename R::LinkWrenches;
};

template <class R>
concept FixedBase = RobotTraits<R> && !R::kFloatingBase;

template <class R>
concept FloatingBase = RobotTraits<R> && R::kFloatingBase;

// inverse_dynamics(q, qd, qdd) returns the joint forces. For a floating base without a wrench on it, the function also
// takes the velocity of the base and returns its acceleration; inverse_dynamics_fully_actuated takes the acceleration
// and returns the wrench that the base needs. All take gravity and external wrenches as further arguments; gravity is
// optional with a fixed base.
template <class R>
concept HasInverseDynamics = (FixedBase<R> &&
                              requires(
                                  const R& robot,
                                  const JointPositions<R>& q,
                                  const typename R::JointState& qd,
                                  const typename R::Gravity& gravity,
                                  const typename R::LinkWrenches& external) {
                                { robot.inverse_dynamics(q, qd, qd) }
                                noexcept->std::same_as<typename R::JointState>;
                                { robot.inverse_dynamics(q, qd, qd, gravity) }
                                noexcept->std::same_as<typename R::JointState>;
                                { robot.inverse_dynamics(q, qd, qd, gravity, external) }
                                noexcept->std::same_as<typename R::JointState>;
                              }) ||
                             (FloatingBase<R> && requires(
                                                     const R& robot,
                                                     const JointPositions<R>& q,
                                                     const typename R::JointState& qd,
                                                     const typename R::Twist& v,
                                                     const typename R::SpatialAcceleration& a,
                                                     const typename R::Gravity& gravity,
                                                     const typename R::LinkWrenches& external) {
                               { robot.inverse_dynamics(q, qd, qd, v, gravity) }
                               noexcept->std::same_as<typename R::InverseDynamics>;
                               { robot.inverse_dynamics(q, qd, qd, v, gravity, external) }
                               noexcept->std::same_as<typename R::InverseDynamics>;
                               { robot.inverse_dynamics_fully_actuated(q, qd, qd, v, a, gravity, external) }
                               noexcept->std::same_as<typename R::GeneralizedForce>;
                             });

// forward_dynamics(q, qd, tau) returns the joint accelerations; with a floating base it also takes the velocity of the
// base and returns its acceleration.
template <class R>
concept HasForwardDynamics = (FixedBase<R> &&
                              requires(
                                  const R& robot,
                                  const JointPositions<R>& q,
                                  const typename R::JointState& qd,
                                  const typename R::Gravity& gravity,
                                  const typename R::LinkWrenches& external) {
                                { robot.forward_dynamics(q, qd, qd) }
                                noexcept->std::same_as<typename R::JointState>;
                                { robot.forward_dynamics(q, qd, qd, gravity) }
                                noexcept->std::same_as<typename R::JointState>;
                                { robot.forward_dynamics(q, qd, qd, gravity, external) }
                                noexcept->std::same_as<typename R::JointState>;
                              }) ||
                             (FloatingBase<R> && requires(
                                                     const R& robot,
                                                     const JointPositions<R>& q,
                                                     const typename R::JointState& qd,
                                                     const typename R::Twist& v,
                                                     const typename R::Gravity& gravity,
                                                     const typename R::LinkWrenches& external) {
                               { robot.forward_dynamics(q, qd, qd, v, gravity) }
                               noexcept->std::same_as<typename R::GeneralizedAcceleration>;
                               { robot.forward_dynamics(q, qd, qd, v, gravity, external) }
                               noexcept->std::same_as<typename R::GeneralizedAcceleration>;
                             });

// joint_space_inertia(q): symmetric; with a floating base (6 + n) x (6 + n), base first.
template <class R>
concept HasJointSpaceInertia = RobotTraits<R> && requires(const R& robot, const JointPositions<R>& q) {
  { robot.joint_space_inertia(q) }
  noexcept->std::same_as<typename R::InertiaMatrix>;
};

// joint_space_inertia_factor(q): L of H = L^T L, and solutions with it; x has the coordinates of H.
template <class R>
concept HasJointSpaceInertiaFactor = RobotTraits<R> && requires(
    const R& robot,
    const JointPositions<R>& q,
    const typename R::InertiaFactor& factor,
    const Matrix<typename R::Scalar, R::InertiaMatrix::RowsAtCompileTime, 1>& x) {
  { robot.joint_space_inertia_factor(q) }
  noexcept->std::same_as<typename R::InertiaFactor>;
  { factor.L() }
  noexcept->std::same_as<const typename R::InertiaMatrix&>;
  { factor.solve(x) }
  noexcept->std::same_as<Matrix<typename R::Scalar, R::InertiaMatrix::RowsAtCompileTime, 1>>;
  { factor.inverse() }
  noexcept->std::same_as<typename R::InertiaMatrix>;
  { factor.inverse_L() }
  noexcept->std::same_as<typename R::InertiaMatrix>;
};

// bias_forces(q, qd) = coriolis_forces(q, qd) + gravity_forces(q). With a floating base, bias_forces and
// coriolis_forces also take its velocity, and all three results contain the wrench on it.
template <class R>
concept HasBiasForces = (FixedBase<R> &&
                         requires(
                             const R& robot,
                             const JointPositions<R>& q,
                             const typename R::JointState& qd,
                             const typename R::Gravity& gravity) {
                           { robot.bias_forces(q, qd) }
                           noexcept->std::same_as<typename R::JointState>;
                           { robot.bias_forces(q, qd, gravity) }
                           noexcept->std::same_as<typename R::JointState>;
                           { robot.gravity_forces(q, gravity) }
                           noexcept->std::same_as<typename R::JointState>;
                           { robot.coriolis_forces(q, qd) }
                           noexcept->std::same_as<typename R::JointState>;
                         }) ||
                        (FloatingBase<R> && requires(
                                                const R& robot,
                                                const JointPositions<R>& q,
                                                const typename R::JointState& qd,
                                                const typename R::Twist& v,
                                                const typename R::Gravity& gravity) {
                          { robot.bias_forces(q, qd, v, gravity) }
                          noexcept->std::same_as<typename R::GeneralizedForce>;
                          { robot.gravity_forces(q, gravity) }
                          noexcept->std::same_as<typename R::GeneralizedForce>;
                          { robot.coriolis_forces(q, qd, v) }
                          noexcept->std::same_as<typename R::GeneralizedForce>;
                        });

// generalized_momentum(q, qd), which also takes the velocity of a floating base and gravity; its result has the members
// p and rate, of as many rows as the inertia matrix.
template <class R>
concept HasControlTerms = (FixedBase<R> &&
                           requires(const R& robot, const JointPositions<R>& q, const typename R::JointState& qd) {
                             robot.generalized_momentum(q, qd).p;
                             robot.generalized_momentum(q, qd).rate;
                           }) ||
                          (FloatingBase<R> && requires(
                                                  const R& robot,
                                                  const JointPositions<R>& q,
                                                  const typename R::JointState& qd,
                                                  const typename R::Twist& v,
                                                  const typename R::Gravity& gravity) {
                            robot.generalized_momentum(q, qd, v, gravity).p;
                            robot.generalized_momentum(q, qd, v, gravity).rate;
                          });

// kinetic_energy(q, qd), which also takes the velocity of a floating base, and potential_energy(q, gravity).
template <class R>
concept HasEnergy = ((FixedBase<R> &&
                      requires(const R& robot, const JointPositions<R>& q, const typename R::JointState& qd) {
                        { robot.kinetic_energy(q, qd) }
                        noexcept->std::same_as<typename R::Scalar>;
                      }) ||
                     (FloatingBase<R> &&
                      requires(
                          const R& robot,
                          const JointPositions<R>& q,
                          const typename R::JointState& qd,
                          const typename R::Twist& v) {
                        { robot.kinetic_energy(q, qd, v) }
                        noexcept->std::same_as<typename R::Scalar>;
                      })) &&
                    requires(const R& robot, const JointPositions<R>& q, const typename R::Gravity& gravity) {
  { robot.potential_energy(q, gravity) }
  noexcept->std::same_as<typename R::Scalar>;
};

// center_of_mass(q), its Jacobian and the centroidal momentum matrix.
template <class R>
concept HasCentroidal = RobotTraits<R> && requires(const R& robot, const JointPositions<R>& q) {
  { robot.center_of_mass(q) }
  noexcept->std::same_as<typename R::Vector3>;
  robot.center_of_mass_jacobian(q);
  robot.centroidal_momentum_matrix(q);
};

// Number of rows of all contacts: three for each point, six for each surface.
template <class R>
requires requires(const R& robot, const JointPositions<R>& q) {
  robot.contact_jacobian(q);
}
inline constexpr int kContactRows = std::remove_cvref_t<decltype(std::declval<const R&>().contact_jacobian(
    std::declval<const JointPositions<R>&>()))>::RowsAtCompileTime;

// Functions of contacts. Those that depend on joint velocities also take the velocity of a floating base.
template <class R>
concept HasContacts = RobotTraits<R> && requires(const R& robot, const JointPositions<R>& q) {
  { robot.contact_jacobian(q) }
  noexcept->std::same_as<Matrix<typename R::Scalar, kContactRows<R>, R::InertiaMatrix::RowsAtCompileTime>>;
  { robot.inverse_contact_inertia(q) }
  noexcept->std::same_as<Matrix<typename R::Scalar, kContactRows<R>, kContactRows<R>>>;
} &&
    ((FixedBase<R> &&
      requires(const R& robot, const JointPositions<R>& q, const typename R::JointState& qd) {
        { robot.contact_velocity(q, qd) }
        noexcept->std::same_as<Matrix<typename R::Scalar, kContactRows<R>, 1>>;
        { robot.contact_bias(q, qd) }
        noexcept->std::same_as<Matrix<typename R::Scalar, kContactRows<R>, 1>>;
      }) ||
     (FloatingBase<R> && requires(
                             const R& robot,
                             const JointPositions<R>& q,
                             const typename R::JointState& qd,
                             const typename R::Twist& v,
                             const typename R::SpatialAcceleration& a,
                             const Matrix<typename R::Scalar, kContactRows<R>, 1>& rows,
                             const typename R::Gravity& gravity) {
       { robot.contact_velocity(q, qd, v) }
       noexcept->std::same_as<Matrix<typename R::Scalar, kContactRows<R>, 1>>;
       { robot.contact_bias(q, qd, v) }
       noexcept->std::same_as<Matrix<typename R::Scalar, kContactRows<R>, 1>>;
       { robot.inverse_dynamics_with_contacts(q, qd, qd, v, a, rows, gravity) }
       noexcept->std::same_as<typename R::GeneralizedForce>;
     }));

// The dynamics for controllers and simulators.
template <class R>
concept HasDynamics = HasInverseDynamics<R> && HasForwardDynamics<R> && HasJointSpaceInertia<R> && HasBiasForces<R>;

template <class R>
concept FixedBaseRobot = FixedBase<R> && HasDynamics<R>;

template <class R>
concept FloatingBaseRobot = FloatingBase<R> && HasDynamics<R>;

}  // namespace robcogen

#else
#error "robcogen/concepts.h needs C++20: compile with -std=c++20"
#endif
