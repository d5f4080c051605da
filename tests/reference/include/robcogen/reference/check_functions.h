// The checks of a subject that has all functions of the dynamics, and those of frames.
#pragma once

#include "robcogen/reference/check_control.h"
#include "robcogen/reference/check_dynamics.h"
#include "robcogen/reference/check_factor.h"
#include "robcogen/reference/check_frame_motion.h"
#include "robcogen/reference/check_identities.h"
#include "robcogen/reference/check_kinematics.h"

namespace robcogen::reference {

// Without regressors and derivatives.
template <class Subject>
void check_functions(const Subject& subject, const Case& c, Checks& checks) {
  check_inverse_dynamics(subject, c, checks);
  check_bias_forces(subject, c, checks);
  check_gravity_gradient(subject, c, checks);
  check_forward_dynamics(subject, c, checks);
  check_round_trips(subject, c, checks);
  check_inertia_matrix(subject, c, checks);
  check_inertia_structure(subject, c, checks);
  check_inertia_columns(subject, c, checks);
  check_energy(subject, c, checks);
  check_power(subject, c, checks);
  check_inertia_factor(subject, c, checks);
  check_factor_dynamics(subject, c, checks);
  check_coriolis_matrix(subject, c, checks);
  check_generalized_momentum(subject, c, checks);
  if (!c.floating) check_path_dynamics(subject, c, checks);
  check_center_of_mass(subject, c, checks);
  check_centroidal_momentum(subject, c, checks);
  check_free_fall(subject, c, checks);
  check_energies(subject, c, checks);
  check_transforms(subject, c, checks);
  check_jacobians(subject, c, checks);
  check_frame_motions(subject, c, checks);
}

}  // namespace robcogen::reference
