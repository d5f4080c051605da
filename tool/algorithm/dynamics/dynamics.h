// The dynamics algorithms, each written once over symbolic scalars: model in, program out.
//
// Conventions of all algorithms: SI units; joint arrays in the order of the document's joints; 6D vectors angular
// first; base twist, base acceleration (spatial, gravity not included), gravity and base wrench in base coordinates
// about the base origin; an external wrench acts on its link, in link coordinates about the link's origin.
//
// Functions that are compared in many formulations can also be traced without building a program: the `trace_`
// functions take a new Trace and declare its inputs and outputs.
#pragma once

#include <string>

#include "algorithm/dynamics/loads.h"
#include "algorithm/formulation/formulation.h"
#include "model/kinematic_tree.h"
#include "symbolic/program.h"
#include "symbolic/solved_columns.h"

namespace robcogen::algorithm {

// Recursive Newton-Euler (Featherstone 2008, table 5.1). Fixed base: q, qd, qdd -> tau. Floating base, fully actuated:
// q, qd, qdd, base_velocity, base_acceleration -> tau, base_wrench.
symbolic::Program newton_euler(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});
void trace_newton_euler(Trace& trace, Loads loads, const Formulation& formulation);

// Inverse dynamics with an unactuated floating base (Featherstone 2008, table 9.6): q, qd, qdd, base_velocity -> tau,
// base_acceleration.
symbolic::Program unactuated_base_inverse_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});
void trace_unactuated_base_inverse_dynamics(Trace& trace, Loads loads, const Formulation& formulation);

// Forces at zero acceleration, passive forces of drives included: q, qd [, base_velocity] -> tau [, base_wrench].
symbolic::Program bias_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// The part of the bias forces that velocities cause.
symbolic::Program coriolis_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = {});

// The passive forces that the joints must overcome in their drives (damping, friction and springs): q, qd -> tau.
symbolic::Program passive_forces(const model::KinematicTree& tree, const std::string& name);

// The torque at the shaft of each motor, which is tau divided by the ratio of the rotor, or tau itself for a joint
// without a rotor: tau -> torque.
symbolic::Program motor_torques(const model::KinematicTree& tree, const std::string& name);

// The part of the bias forces that gravity causes, from the first moments of composite bodies: q ->
// tau [, base_wrench].
symbolic::Program gravity_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

enum class ForwardDynamicsMethod {
  articulated_bodies,  // Featherstone 2008, table 7.1
  inertia_matrix,      // bias forces, inertia matrix and elimination along ancestors: tables 5.1, 6.2, sec. 6.5
};

struct ForwardDynamicsChoice {
  ForwardDynamicsMethod method = ForwardDynamicsMethod::articulated_bodies;
  Formulation formulation;
};

// False if joints are coupled, or if a rotor is on a moving link that is not the parent of its joint. Then the
// articulated inertia of the parent is not all that the joint meets, and forward dynamics always uses the inertia
// matrix.
bool allows_articulated_bodies(const model::KinematicTree& tree);

// q, qd, tau [, base_velocity] -> qdd [, base_acceleration].
symbolic::Program forward_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const ForwardDynamicsChoice& choice);
void trace_forward_dynamics(Trace& trace, Loads loads, const ForwardDynamicsChoice& choice);

// Composite-rigid-body algorithm (Featherstone 2008, table 6.2): q -> H, n x n, or (6 + n) x (6 + n) base first. The
// zeros that branches induce are literal.
symbolic::Program joint_space_inertia(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = {});
void trace_joint_space_inertia(Trace& trace, const Formulation& formulation);

// L of H = L^T L with the sparsity that branches induce (Featherstone 2008, sec. 6.5): q -> L, of the size of H, and
// the reciprocals of its diagonal. L(i, j) is a literal zero unless j is i or an ancestor of i; so L is lower
// triangular if the document declares joints after the ones that carry them. H must be positive definite: results are
// not finite otherwise.
symbolic::Program joint_space_inertia_factor(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = {});
// Functions of a factor; `factor` is the program above: L, inverse_diagonal, x -> y = H^-1 x.
symbolic::Program inertia_factor_solve(
    const model::KinematicTree& tree,
    const symbolic::Program& factor,
    const std::string& name);
// L, inverse_diagonal -> L^-1, as sparse as L.
symbolic::Program inertia_factor_inverse_L(
    const model::KinematicTree& tree,
    const symbolic::Program& factor,
    const std::string& name);
// L, inverse_diagonal -> H^-1. An element is zero if no coordinate is an ancestor of both its row and its column.
symbolic::Program inertia_factor_inverse(
    const model::KinematicTree& tree,
    const symbolic::Program& factor,
    const std::string& name);
// The same in a loop over columns, without the zeros.
symbolic::SolvedColumns inertia_factor_inverse_L_in_columns(
    const model::KinematicTree& tree,
    const symbolic::Program& factor,
    const std::string& name);
symbolic::SolvedColumns inertia_factor_inverse_in_columns(
    const model::KinematicTree& tree,
    const symbolic::Program& factor,
    const std::string& name);

// A factorisation of the Coriolis forces that makes dH/dt - 2 C skew symmetric (Niemeyer and Slotine 1991; recursive
// with composite bodies: Echeandia and Wensing 2021): q, qd [, base_velocity] -> C, of the size of H. C v plus the
// gravity forces are the bias forces.
symbolic::Program coriolis_matrix(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = {});

// The generalised momentum p = H v, and its rate without the generalised forces tau, dp/dt - tau: q, qd [,
// base_velocity] [, gravity] -> p, rate, as the rows of H. Momentum observers integrate it (De Luca and Mattone 2003).
symbolic::Program generalized_momentum(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// The joint forces along a path q(s) of a robot on a fixed base, tau = a dds/dt^2 + b (ds/dt)^2 + c, without passive
// forces: q, qd = dq/ds, qdd = d^2q/ds^2 [, gravity] -> a, b, c.
symbolic::Program path_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// Inverse dynamics and its partial derivatives by each variable (force_derivatives.h): q, qd, qdd -> tau, d_q, d_qd,
// d_qdd, the last of which is H. Floating base, fully actuated: q, qd, qdd, base_velocity, base_acceleration -> tau,
// base_wrench, d_q, d_qd, d_qdd, d_base_rotation, d_base_velocity, d_base_acceleration, rows of the base wrench first.
symbolic::Program inverse_dynamics_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});
void trace_inverse_dynamics_derivatives(Trace& trace, Loads loads, const Formulation& formulation);

// The same with an unactuated floating base: q, qd, qdd, base_velocity -> tau, base_acceleration, d_q, d_qd, d_qdd,
// d_base_rotation, d_base_velocity, rows of the base acceleration first.
symbolic::Program unactuated_base_inverse_dynamics_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// The same, with a loop over right-hand sides.
symbolic::SolvedColumns unactuated_base_inverse_dynamics_derivatives_in_columns(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// Forward dynamics and its derivatives: q, qd, tau [, base_velocity] -> qdd [, base_acceleration], d_q, d_qd, d_tau [,
// d_base_rotation, d_base_velocity], rows of the base acceleration first. d_tau: columns of H^-1.
symbolic::Program forward_dynamics_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});
// The same, with a loop over right-hand sides.
symbolic::SolvedColumns forward_dynamics_derivatives_in_columns(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// Inverse dynamics (fully actuated), and the gradient of the sum of its forces (base wrench, tau) weighted by
// `weights`, by reverse mode (symbolic/derivative.h): inputs of newton_euler, weights in front of gravity -> tau [,
// base_wrench], d_q, d_qd, d_qdd [, d_base_velocity, d_base_acceleration].
symbolic::Program inverse_dynamics_gradient(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// The same, and the second derivatives of that sum: -> … d_q_q, d_qd_q, d_qdd_q, d_qd_qd, with rows by the first and
// columns by the second input. With a floating base, base_velocity and base_acceleration are treated like qd and qdd.
// All other second derivatives are zero, because forces are linear in accelerations.
symbolic::Program inverse_dynamics_second_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// The derivatives of the gravity forces: q -> d_q, n x n and symmetric. Floating base: d_q, d_base_rotation, rows of
// the base wrench first.
symbolic::Program gravity_forces_derivative(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

// The mass of all that moves (every link but a fixed base), a function of the parameters alone: -> mass.
symbolic::Program total_mass(const model::KinematicTree& tree, const std::string& name);

// Whether results are in axes of the base (and positions in base coordinates) or in those of the world. In the latter
// case `base_pose` (Role::base_pose) is an input after those of the joints.
enum class CentroidalAxes { of_base, of_world };

// In these functions, other mass properties than those of the links (base parameters) are for floating bases only.

// The centre of mass of all that moves: q -> com. In axes of the base it is zero if no moving link has mass.
symbolic::Program center_of_mass(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = plain_formulation(),
    CentroidalAxes axes = CentroidalAxes::of_base);
// The Jacobian of the velocity of that point: q -> J, 3 x n, or 3 x (6 + n) base twist first.
symbolic::Program center_of_mass_jacobian(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = plain_formulation(),
    CentroidalAxes axes = CentroidalAxes::of_base);
// The matrix of the spatial momentum about that point (Orin, Goswami, Lee 2013): q -> A, 6 x n, or 6 x (6 + n) base
// twist first; angular rows first.
symbolic::Program centroidal_momentum_matrix(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = plain_formulation(),
    CentroidalAxes axes = CentroidalAxes::of_base);

// The rate of that momentum in an inertial frame, minus A times (base acceleration, qdd) (Wensing and Orin 2016): q, qd
// [, base_velocity] -> bias, 6.
symbolic::Program centroidal_momentum_bias(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = plain_formulation(),
    CentroidalAxes axes = CentroidalAxes::of_base);

// The velocity of the centre of mass and the momentum about it, in axes of the world: q, qd, base_pose [,
// base_velocity] -> v, or h, angular first.
symbolic::Program center_of_mass_velocity(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = plain_formulation());
symbolic::Program centroidal_momentum(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = plain_formulation());

// q, qd [, base_velocity] -> T, summed over the links.
symbolic::Program kinetic_energy(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation = {});
// q -> V of all that moves; it is zero when the centre of mass is at the base origin.
symbolic::Program potential_energy(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative = {});

// Forward dynamics of all joints of the tree whose loops are cut and whose couplings are open, with the forces that
// hold these closed (Featherstone 2008, sec. 8.5, through the sparse factor of sec. 6.5): positions, velocities,
// joint_forces (in the order of joint_positions) [, base_velocity], stabilization = (1/s^2, 1/s) (Baumgarte 1972),
// compliance [, gravity] [, external] -> accelerations [, base_acceleration], loop_forces (as below)
// [, coupling_forces].
symbolic::Program loop_constrained_forward_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation);

// The forces between the two frames of each loop: q, qd, qdd [, base_velocity, base_acceleration] [, gravity]
// [, external] -> forces, by loop: three for a loop in a plane, one for a distance (Trace::reactions).
symbolic::Program loop_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation);

}  // namespace robcogen::algorithm
