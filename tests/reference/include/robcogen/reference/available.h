// The functions that a library has: those of the selected groups, except those that the robot's mass properties do not
// allow (forward dynamics of a robot whose inertia matrix is singular). The library's own table lists them.
//
// Include the robot's reflection header first; needs ROBCOGEN_ROBOT_NAMESPACE.
#pragma once

#include <string_view>

#include "robcogen/reflection.h"

namespace robcogen::reference {

constexpr bool has_kernel(std::string_view name) {
  const reflection::Robot& robot = ROBCOGEN_ROBOT_NAMESPACE::reflection::robot;
  for (int i = 0; i < robot.functions.size; ++i)
    if (robot.functions[i].name == name) return true;
  return false;
}

constexpr bool kHasInverseDynamics = has_kernel("inverse_dynamics");
constexpr bool kHasBiasForces = has_kernel("bias_forces");
constexpr bool kHasPassiveForces = has_kernel("passive_forces");
constexpr bool kHasForwardDynamics = has_kernel("forward_dynamics");
constexpr bool kHasInertia = has_kernel("joint_space_inertia");
constexpr bool kHasFactor = has_kernel("joint_space_inertia_factor");
constexpr bool kHasCoriolisMatrix = has_kernel("coriolis_matrix");
constexpr bool kHasControlTerms = has_kernel("generalized_momentum");
constexpr bool kHasInverseDynamicsDerivatives = has_kernel("gravity_forces_derivative");
constexpr bool kHasFreeInverseDynamicsDerivatives = has_kernel("inverse_dynamics_derivatives");
constexpr bool kHasInverseDynamicsGradient = has_kernel("inverse_dynamics_gradient");
constexpr bool kHasForwardDynamicsDerivatives = has_kernel("forward_dynamics_derivatives");
constexpr bool kHasRegressor = has_kernel("regressor");
constexpr bool kHasBaseRegressor = has_kernel("base_regressor");
constexpr bool kHasEnergyRegressor = has_kernel("energy_regressor");
constexpr bool kHasSlotineLiRegressor = has_kernel("slotine_li_regressor");
constexpr bool kHasCentroidal = has_kernel("center_of_mass");
constexpr bool kHasEnergy = has_kernel("kinetic_energy");

}  // namespace robcogen::reference
