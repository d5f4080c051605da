// Dynamics with contacts: frames that touch a fixed environment with a point or a surface.
//
// Conventions of all functions: rows of contacts in the order of the list, angular ones first, three for a point and
// six for a surface; velocities, accelerations, impulses and wrenches of contacts in base axes, about the origin of the
// contact frame; wrenches act on the robot. Velocities v and accelerations a have an element for each row of the
// joint-space inertia matrix: base twist first. A contact is open if `active` is 0 and holds if it is 1, without
// branches in the code. `compliance` (by row, rad/s^2 per N m or m/s^2 per N) is added to the diagonal of W: zero for
// rigid contacts, whose rows must then be independent; with a small number redundant contacts share the load.
#pragma once

#include <string>

#include "algorithm/dynamics/contact_rows.h"
#include "algorithm/formulation/formulation.h"
#include "symbolic/solved_columns.h"

namespace robcogen::algorithm {

// q -> J, with a row for each row of the contacts and a column for each coordinate of H.
symbolic::Program contact_jacobian(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name);

// q, qd [, base_velocity] -> J v.
symbolic::Program contact_velocity(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name);

// q, qd [, base_velocity] -> the acceleration of the contact frames minus J a.
symbolic::Program contact_bias(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation = {});

// q -> W = J H^-1 J^T (Featherstone 2008, sec. 8.4: inverse operational-space inertia).
symbolic::Program inverse_contact_inertia(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation = {});

// Forward dynamics in which active contacts accelerate by `contact_acceleration`: zero, or terms of Baumgarte (1972).
// q, qd, tau [, base_velocity], contact_acceleration, active, compliance -> qdd [, base_acceleration],
// contact_wrenches.
symbolic::Program constrained_forward_dynamics(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// Velocities after an impact at active contacts, J v+ = -restitution J v- (Newton; `restitution` by contact): q, qd [,
// base_velocity], restitution, active, compliance -> qd_after [, base_velocity_after], contact_impulses.
symbolic::Program impact(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation = {});

// The derivatives of both: a matrix with rows of (base acceleration, qdd, contact_wrenches) for each input that is
// named after `d_`. External wrenches are constant in link coordinates, contact_acceleration in base axes; compliance
// and active are constant. -> outputs of constrained_forward_dynamics, d_q, d_qd, d_tau [, d_base_rotation (as in
// forward_dynamics_derivatives), d_base_velocity], d_contact_acceleration.
symbolic::Program constrained_forward_dynamics_derivatives(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});
// -> outputs of impact, d_q, d_qd [, d_base_velocity], d_restitution, with rows of (base_velocity_after, qd_after,
// contact_impulses).
symbolic::Program impact_derivatives(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation = {});
// The same, with loops over right-hand sides.
symbolic::SolvedColumns constrained_forward_dynamics_derivatives_in_columns(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});
symbolic::SolvedColumns impact_derivatives_in_columns(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation = {});

// Inverse dynamics with given wrenches at the contacts: q, qd, qdd [, base_velocity, base_acceleration],
// contact_wrenches -> tau [, base_wrench].
symbolic::Program inverse_dynamics_with_contacts(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// Inverse dynamics of a robot whose floating base is held by contacts. Among the wrenches f that give the base its
// acceleration, those that minimise the sum of f^2 / weights are chosen; `weights` is by row, zero for a contact that
// is open. With a positive `regularization` r (N m or N per unit of the multiplier y of the base), the wrench r y on
// the base may be missing; it is returned as base_wrench: q, qd, qdd, base_velocity, base_acceleration, weights,
// regularization -> tau, contact_wrenches, base_wrench.
symbolic::Program constrained_inverse_dynamics(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// The same with the smallest sum of torque_weights tau^2 + f^2 / weights (Righetti, Buchli, Mistry, Kalakrishnan,
// Schaal: Optimal distribution of contact forces with inverse-dynamics control, IJRR 2013); `torque_weights` is by
// coordinate. Without them it is constrained_inverse_dynamics: q, qd, qdd, base_velocity, base_acceleration, weights,
// torque_weights, regularization -> tau, contact_wrenches, base_wrench.
symbolic::Program minimum_torque_inverse_dynamics(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// The contact frames as a task (Khatib 1987): q, active, compliance -> inertia = W^-1, inverse = H^-1 J^T W^-1
// (dynamically consistent), projector = 1 - inverse J. Rows of frames that are not active are zero.
symbolic::Program operational_space(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation = {});

}  // namespace robcogen::algorithm
