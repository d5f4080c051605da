// Coordinate transforms and geometric Jacobians between the frames of a robot.
#pragma once

#include <string>
#include <vector>

#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

enum class TransformForm {
  homogeneous,     // 4 x 4: [R p; 0 1]
  spatial_motion,  // 6 x 6: [R 0; [p]x R  R], angular first
  spatial_force,   // 6 x 6: [R [p]x R; 0 R], angular first
};

// left_X_right, R = left_R_right and p the origin of `right` in `left`: q -> X, column by column.
symbolic::Program coordinate_transform(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    TransformForm form,
    const std::string& name);

// The reference in which a Jacobian gives the velocity of `right` with respect to `left`; the angular rows give the
// angular velocity in the same axes.
enum class JacobianReference {
  in_left,    // velocity of the origin of `right`, in axes of `left`
  in_target,  // the same velocity in axes of `right`
  spatial,    // twist about the origin of `left`: velocity of the point of `right` that is there, in axes of `left`
};

// left_J_right, angular rows first: q -> J, 6 x k, one column for each joint of the chain, or for each coordinate that
// its joints follow (Siciliano et al. 2009, ch. 3). A joint that the chain passes from child to parent counts with the
// opposite sign.
symbolic::Program geometric_jacobian(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name,
    JacobianReference reference = JacobianReference::in_left);

// Angular velocity of `right` and velocity of its origin in an inertial frame, in axes of `left`, a frame of the base:
// q -> J, 6 x n, or 6 x (6 + n) base twist first; angular rows first. All coordinates have a column.
symbolic::Program jacobian_with_base(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name);

// The acceleration of `right`, angular first, in an inertial frame and in axes of `left`, minus the product of that
// Jacobian with (base acceleration, qdd): q, qd [, base_velocity] -> a.
symbolic::Program jacobian_with_base_bias(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name);

// Time derivative of left_J_right (in_left): q, qd -> Jd, 6 x k.
symbolic::Program jacobian_derivative(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name);

// Jd qd of all joints of the chain: angular acceleration of `right` with respect to `left`, and acceleration of its
// origin, if the joints do not accelerate, in axes of `left`: q, qd -> a.
symbolic::Program jacobian_derivative_times_velocity(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name);

// Twist of `right` with respect to `left`, about the origin and in axes of `left`: q, qd -> V.
symbolic::Program frame_velocity(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name);

// The time derivative of that twist, in coordinates of `left`: q, qd, qdd -> A.
symbolic::Program frame_acceleration(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name);

// The coordinates that move the joints of the chain from left to right, in order: the columns of the Jacobian.
std::vector<int> chain_coordinates(const model::KinematicTree& tree, const model::FramePair& frames);

// Positions of all joints, coupled ones after the others: q -> positions.
symbolic::Program joint_positions(const model::KinematicTree& tree, const std::string& name);

// The positions after one second at constant velocities, also for spherical joints: q, qd -> positions, with
// quaternions of unit length.
symbolic::Program integrate_positions(const model::KinematicTree& tree, const std::string& name);

// The velocities that lead from one position to another in one second, by the shorter way: q_from, q_to -> qd.
symbolic::Program position_difference(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::algorithm
