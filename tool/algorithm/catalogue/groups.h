// The functions of each group (catalogue.h).
#pragma once

#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/dynamics/contacts.h"

namespace robcogen::algorithm {

// ---- Dynamics: functions of the whole robot.

std::vector<RobotFunction> inverse_dynamics_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> bias_forces_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> passive_forces_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> forward_dynamics_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> joint_space_inertia_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> joint_space_inertia_factor_functions(
    const model::KinematicTree& tree,
    FormulationChoices& choices);
std::vector<RobotFunction> coriolis_matrix_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> inverse_dynamics_derivatives_functions(
    const model::KinematicTree& tree,
    FormulationChoices& choices);
std::vector<RobotFunction> inverse_dynamics_gradient_functions(
    const model::KinematicTree& tree,
    FormulationChoices& choices);
std::vector<RobotFunction> inverse_dynamics_second_derivatives_functions(
    const model::KinematicTree& tree,
    FormulationChoices& choices);
std::vector<RobotFunction> forward_dynamics_derivatives_functions(
    const model::KinematicTree& tree,
    FormulationChoices& choices);
std::vector<RobotFunction> centroidal_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> energy_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> centroidal_bias_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> regressor_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> base_regressor_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> energy_regressor_functions(const model::KinematicTree& tree, FormulationChoices& choices);
std::vector<RobotFunction> slotine_li_regressor_functions(
    const model::KinematicTree& tree,
    FormulationChoices& choices);

// ---- Loops and actuators, if the robot has some.

// Added to `transforms`, `jacobians`, `inverse_dynamics` and `forward_dynamics`.
void add_joint_positions(std::vector<RobotFunction>& list, const model::KinematicTree& tree);
void add_actuator_lengths(std::vector<RobotFunction>& list, const model::KinematicTree& tree);
void add_lever_arms(std::vector<RobotFunction>& list, const model::KinematicTree& tree);
void add_loop_errors(std::vector<RobotFunction>& list, const model::KinematicTree& tree);
void add_loop_jacobian(std::vector<RobotFunction>& list, const model::KinematicTree& tree);
void add_loop_forces(std::vector<RobotFunction>& list, const model::KinematicTree& tree, FormulationChoices& choices);
void add_loop_constrained_dynamics(
    std::vector<RobotFunction>& list,
    const model::KinematicTree& tree,
    FormulationChoices& choices);

// ---- Contacts: functions of all desired contact frames, at least one.

std::vector<RobotFunction> contacts_functions(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    FormulationChoices& choices);
std::vector<RobotFunction> constrained_forward_dynamics_derivatives_functions(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    FormulationChoices& choices);
std::vector<RobotFunction> operational_space_functions(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    FormulationChoices& choices);

// ---- Kinematics: functions of each desired pair of frames.

std::vector<RobotFunction> transforms_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired);
std::vector<RobotFunction> jacobians_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired);
std::vector<RobotFunction> jacobian_references_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired);
std::vector<RobotFunction> jacobians_with_base_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired);
std::vector<RobotFunction> jacobian_derivatives_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired);
std::vector<RobotFunction> velocities_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired);
std::vector<RobotFunction> accelerations_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired);

// ---- In the world: functions of each desired frame, and of the whole robot.

std::vector<RobotFunction> world_functions(const model::KinematicTree& tree, const model::DesiredTransforms& desired);
std::vector<RobotFunction> world_centroidal_functions(const model::KinematicTree& tree, FormulationChoices& choices);

}  // namespace robcogen::algorithm
