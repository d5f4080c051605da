// The self-check of one generated library (robcogen/reference/selfcheck.h). Compiled once per robot, with
//     ROBCOGEN_ROBOT_HEADER, ROBCOGEN_REFLECTION_HEADER   the generated headers, as <…>
//     ROBCOGEN_ROBOT_NAMESPACE                            the namespace of the generated code
//     ROBCOGEN_BATCH_HEADER                               where the library has functions over many states
//     ROBCOGEN_ROBOT_HAS_LEVELS                           where it has kernels for several processors: each is checked
//     ROBCOGEN_ROBOT_HAS_SINGLE_PRECISION                 where it has a namespace f32
//
//     hyl_selfcheck [--seed N] [--samples N]
#include ROBCOGEN_ROBOT_HEADER
#include ROBCOGEN_REFLECTION_HEADER

#include "robcogen/reference/available.h"
#include "robcogen/reference/check_parameters.h"
#include "robcogen/reference/compiled_robot.h"
#include "robcogen/reference/selfcheck.h"

namespace robcogen::reference {
namespace {

namespace generated = ROBCOGEN_ROBOT_NAMESPACE;

// The functions that have a formulation, which exist in both precisions.
template <class R>
AnySubject dynamics_of(const std::shared_ptr<const CompiledRobot<R>>& robot) {
  using Compiled = CompiledRobot<R>;
  AnySubject s;
  if constexpr (kHasInverseDynamics) {
    s.inverse_dynamics = bound(robot, &Compiled::inverse_dynamics);
    s.inverse_dynamics_fully_actuated = bound(robot, &Compiled::inverse_dynamics_fully_actuated);
  }
  if constexpr (kHasBiasForces) {
    s.bias_forces = bound(robot, &Compiled::bias_forces);
    s.gravity_forces = bound(robot, &Compiled::gravity_forces);
    s.coriolis_forces = bound(robot, &Compiled::coriolis_forces);
  }
  if constexpr (kHasForwardDynamics) s.forward_dynamics = bound(robot, &Compiled::forward_dynamics);
  if constexpr (kHasInertia) s.joint_space_inertia = bound(robot, &Compiled::joint_space_inertia);
  return s;
}

template <class R>
AnySubject subject_of(const std::shared_ptr<const CompiledRobot<R>>& robot) {
  using Compiled = CompiledRobot<R>;
  AnySubject s = dynamics_of(robot);
  if constexpr (kHasPassiveForces) s.passive_forces = bound(robot, &Compiled::passive_forces);
  if constexpr (kHasFactor) s.inertia_factor = bound(robot, &Compiled::inertia_factor);
  if constexpr (kHasCoriolisMatrix) s.coriolis_matrix = bound(robot, &Compiled::coriolis_matrix);
  if constexpr (kHasControlTerms) s.generalized_momentum = bound(robot, &Compiled::generalized_momentum);
  if constexpr (kHasControlTerms && !R::kFloatingBase) s.path_dynamics = bound(robot, &Compiled::path_dynamics);
  if constexpr (kHasInverseDynamicsDerivatives) {
    s.inverse_dynamics_fully_actuated_derivatives =
        bound(robot, &Compiled::inverse_dynamics_fully_actuated_derivatives);
    s.gravity_forces_derivative = bound(robot, &Compiled::gravity_forces_derivative);
  }
  if constexpr (R::kFloatingBase && kHasFreeInverseDynamicsDerivatives)
    s.inverse_dynamics_derivatives = bound(robot, &Compiled::inverse_dynamics_derivatives);
  if constexpr (kHasForwardDynamicsDerivatives)
    s.forward_dynamics_derivatives = bound(robot, &Compiled::forward_dynamics_derivatives);
  if constexpr (kHasInverseDynamicsGradient)
    s.inverse_dynamics_gradient = bound(robot, &Compiled::inverse_dynamics_gradient);
  if constexpr (kHasRegressor) {
    s.regressor = bound(robot, &Compiled::regressor);
    s.drive_regressor = bound(robot, &Compiled::drive_regressor);
    s.inertial_parameters = bound(robot, &Compiled::inertial_parameters);
    s.drive_parameters = bound(robot, &Compiled::drive_parameters);
  }
  if constexpr (kHasBaseRegressor) {
    s.base_regressor = bound(robot, &Compiled::base_regressor);
    s.base_parameters = bound(robot, &Compiled::base_parameters);
  }
  if constexpr (kHasEnergyRegressor) s.energy_regressor = bound(robot, &Compiled::energy_regressor);
  if constexpr (kHasSlotineLiRegressor) s.slotine_li_regressor = bound(robot, &Compiled::slotine_li_regressor);
  if constexpr (kHasCentroidal) {
    if constexpr (kIsParametric<R>) s.total_mass = bound(robot, &Compiled::total_mass);
    s.center_of_mass = bound(robot, &Compiled::center_of_mass);
    s.center_of_mass_jacobian = bound(robot, &Compiled::center_of_mass_jacobian);
    s.centroidal_momentum_matrix = bound(robot, &Compiled::centroidal_momentum_matrix);
  }
  if constexpr (kHasEnergy) {
    s.kinetic_energy = bound(robot, &Compiled::kinetic_energy);
    s.potential_energy = bound(robot, &Compiled::potential_energy);
  }
  s.transform = bound(robot, &Compiled::transform);
  s.jacobian = bound(robot, &Compiled::jacobian);
  s.frame_function = bound(robot, &Compiled::frame_function);
  return s;
}

template <class R>
Library library() {
  Library result;
  result.robot = &generated::reflection::robot;
  if constexpr (kIsParametric<R>) {
    result.subject = [](const Robot& tables, const std::vector<double>& values) {
      return subject_of(std::make_shared<const CompiledRobot<R>>(tables, R{parameters_of<R>(values)}));
    };
    result.cache = [](const std::vector<double>& values) {
      const auto parameters = parameters_of<R>(values);
      return std::vector<double>(parameters.data(), parameters.data() + R::Parameters::size());
    };
    result.check_updates = check_updates<R>;
  } else {
    result.subject = [](const Robot& tables, const std::vector<double>&) {
      return subject_of(std::make_shared<const CompiledRobot<R>>(tables));
    };
    result.cache = [](const std::vector<double>&) { return std::vector<double>(); };
#ifdef ROBCOGEN_ROBOT_HAS_SINGLE_PRECISION
    // The type depends on R, so that it is not instantiated for a robot with parameters.
    using Single = std::conditional_t<kIsParametric<R>, void, generated::f32::Robot>;
    result.single = [](const Robot& tables) {
      return dynamics_of(std::make_shared<const CompiledRobot<Single>>(tables));
    };
#endif
  }
#ifdef ROBCOGEN_BATCH_HEADER
  result.batch_functions = &generated::reflection::batch_functions;
#endif
#ifdef ROBCOGEN_ROBOT_HAS_LEVELS
  result.use_level = generated::reflection::use_level;
#endif
  return result;
}

}  // namespace
}  // namespace robcogen::reference

int main(int argc, char** argv) {
  namespace reference = robcogen::reference;
  return reference::selfcheck(reference::library<reference::generated::Robot>(), argc, argv);
}
