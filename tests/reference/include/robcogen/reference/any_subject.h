// A subject whose functions are values, so that the checks are compiled once for all libraries.
#pragma once

#include <functional>
#include <memory>

#include "robcogen/reference/subject.h"

namespace robcogen::reference {

// The members of CompiledRobot (compiled_robot.h). Functions that a library does not have are empty.
struct AnySubject {
  using State = Motion<double>;
  template <class Result>
  using OfState = std::function<Result(const State&)>;
  template <class Result>
  using OfLoadedState = std::function<Result(const State&, const Arguments&)>;
  template <class Result>
  using OfPositions = std::function<Result(const Vector<double>&)>;
  template <class Result>
  using OfLoadedPositions = std::function<Result(const Vector<double>&, const Arguments&)>;
  template <class Result>
  using OfForces = std::function<Result(const State&, const Vector<double>&, const Arguments&)>;

  OfLoadedState<Vector<double>> inverse_dynamics, inverse_dynamics_fully_actuated, bias_forces;
  OfForces<Vector<double>> forward_dynamics;
  OfLoadedPositions<Vector<double>> gravity_forces;
  OfState<Vector<double>> coriolis_forces, passive_forces;
  OfPositions<Matrix<double>> joint_space_inertia;
  std::function<FactorResults(const Vector<double>& q, const Vector<double>& x)> inertia_factor;
  OfState<Matrix<double>> coriolis_matrix;
  OfLoadedState<MomentumAndRate> generalized_momentum;
  OfLoadedState<PathTerms> path_dynamics;  // with a fixed base

  OfLoadedState<Derivatives> inverse_dynamics_fully_actuated_derivatives;
  OfLoadedState<Derivatives> inverse_dynamics_derivatives;  // with a free base
  OfForces<Derivatives> forward_dynamics_derivatives, inverse_dynamics_gradient;
  OfLoadedPositions<Derivatives> gravity_forces_derivative;

  OfLoadedState<Matrix<double>> regressor, base_regressor, energy_regressor;
  OfState<Matrix<double>> drive_regressor;
  std::function<Vector<double>()> inertial_parameters, drive_parameters;
  OfLoadedPositions<Vector<double>> base_parameters;
  std::function<Matrix<double>(const State&, const State&, const Arguments&)> slotine_li_regressor;

  std::function<double()> total_mass;  // for robots with parameters
  OfPositions<Vector<double>> center_of_mass;
  OfPositions<Matrix<double>> center_of_mass_jacobian, centroidal_momentum_matrix;
  OfState<double> kinetic_energy;
  OfLoadedPositions<double> potential_energy;

  std::function<TransformForms(int index, const Vector<double>& q)> transform;
  std::function<Matrix<double>(int index, const Vector<double>& q)> jacobian;
  std::function<Matrix<double>(int index, const State&)> frame_function;
};

// Binds a member function to its subject, which the result keeps alive.
template <class Subject, class Result, class... Argument>
std::function<Result(Argument...)> bound(
    const std::shared_ptr<const Subject>& subject,
    Result (Subject::*member)(Argument...) const) {
  return [subject, member](Argument... arguments) { return ((*subject).*member)(arguments...); };
}

}  // namespace robcogen::reference
