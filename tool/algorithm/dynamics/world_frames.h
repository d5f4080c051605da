// Frames of a robot whose base has a pose in the world: their position and motion in the world.
//
// Velocities and accelerations are the angular one of the frame, then that of its origin, with respect to the world:
// values that a sensor on the frame would measure (without gravity), not spatial vectors. They are in axes of the
// world, or in those of the frame itself, which takes no pose of the base. Columns have the order of the joint-space
// inertia matrix: base twist in base coordinates first.
#pragma once

#include <string>
#include <vector>

#include "algorithm/dynamics/loads.h"
#include "algorithm/formulation/formulation.h"
#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

enum class Axes { of_world, of_frame };

// q, base_pose -> X: world_X_frame, 4 x 4.
symbolic::Program world_transform(const model::KinematicTree& tree, const model::Frame& frame, const std::string& name);

// q, base_pose -> X, for each of these frames: from the pose of the base along the tree.
symbolic::Program world_transforms(
    const model::KinematicTree& tree,
    const std::vector<model::Frame>& frames,
    const std::string& name);

// q, base_pose -> p: the origin of the frame.
symbolic::Program world_position(const model::KinematicTree& tree, const model::Frame& frame, const std::string& name);

// q, qd [, base_pose] [, base_velocity] -> v.
symbolic::Program world_velocity(
    const model::KinematicTree& tree,
    const model::Frame& frame,
    Axes axes,
    const std::string& name);

// q, qd, qdd [, base_pose] [, base_velocity, base_acceleration] -> a: the time derivative of the velocity in axes of
// the world.
symbolic::Program world_acceleration(
    const model::KinematicTree& tree,
    const model::Frame& frame,
    Axes axes,
    const std::string& name);

// q [, base_pose] -> J: v = J (base_velocity, qd), 6 x n or 6 x (6 + n).
symbolic::Program world_jacobian(
    const model::KinematicTree& tree,
    const model::Frame& frame,
    Axes axes,
    const std::string& name);

// q, qd [, base_pose] [, base_velocity] -> a - J (base_acceleration, qdd).
symbolic::Program world_bias(
    const model::KinematicTree& tree,
    const model::Frame& frame,
    Axes axes,
    const std::string& name);

// The bias of a frame from the motion of its link as the recursion of bias_forces has it, with gravity, for programs
// that are fused with these: in axes of `left`, which is on the base, in those of the world, or in those of the frame.
// q, qd [, base_pose] [, base_velocity] [, gravity] -> a, with this role.
enum class BiasAxes { of_left, of_world, of_frame };
symbolic::Program bias_from_forces(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    BiasAxes axes,
    symbolic::Role role,
    const std::string& name,
    Loads loads,
    const Formulation& formulation);

}  // namespace robcogen::algorithm
