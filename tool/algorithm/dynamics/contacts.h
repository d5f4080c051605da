// Dynamics with contacts: frames that touch what does not move, by a point or by a surface.
//
// Conventions of all of them: rows of contacts in the order of the list, angular ones first, three for a point and six
// for a surface; velocities, accelerations, impulses and wrenches of contacts in base axes, about the origin of the
// contact frame; wrenches act on the robot. Velocities v and accelerations a have an element for each row of the
// joint-space inertia matrix: base twist first. Where `active` is 0 a contact is open, where it is 1 it holds: nothing
// branches. `compliance` (by row, rad/s^2 per N m or m/s^2 per N) is added to the diagonal of W: zero for rigid
// contacts, whose rows must then be independent; a small number makes redundant ones share the load.
#pragma once

#include <string>

#include "algorithm/dynamics/contact_rows.h"
#include "algorithm/formulation/formulation.h"

namespace robcogen::algorithm {

// q -> J, a row each, a column for each coordinate of H.
symbolic::Program contact_jacobian(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name);

// q, qd [, base_velocity] -> J v.
symbolic::Program contact_velocity(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name);

// q, qd [, base_velocity] -> what is added to J a in the acceleration of the contact frames.
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

// Velocities after an impact at active contacts, J v+ = -restitution J v- (Newton; by contact): q, qd [,
// base_velocity], restitution, active, compliance -> qd_after [, base_velocity_after], contact_impulses.
symbolic::Program impact(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation = {});

// Inverse dynamics with these wrenches at the contacts: q, qd, qdd [, base_velocity, base_acceleration],
// contact_wrenches -> tau [, base_wrench].
symbolic::Program inverse_dynamics_with_contacts(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// Inverse dynamics of a floating base that contacts hold, with the wrenches f that minimise the sum of f^2 / weights
// among those that give the base its acceleration; `weights` by row, zero for a contact that is open. A positive
// `regularization` r (N m or N per unit of the multiplier y of the base) allows the wrench r y on the base to be
// missing, which it returns: q, qd, qdd, base_velocity, base_acceleration, weights, regularization -> tau,
// contact_wrenches, base_wrench.
symbolic::Program constrained_inverse_dynamics(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// The contact frames as a task (Khatib 1987): q, active, compliance -> inertia = W^-1, inverse = H^-1 J^T W^-1
// (dynamically consistent), projector = 1 - inverse J. Rows of frames that are not active are left out: zero.
symbolic::Program operational_space(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation = {});

}  // namespace robcogen::algorithm
