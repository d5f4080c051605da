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

// left_J_right: velocity of the origin of `right` with respect to `left`, in coordinates of `left`, angular rows first:
// q -> J, 6 x k, one column for each joint of the chain (Siciliano et al. 2009, ch. 3). A joint that the chain passes
// from child to parent moves the other way.
symbolic::Program geometric_jacobian(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name);

// The joints of the chain from left to right, in order: the columns of the Jacobian.
std::vector<int> chain_joints(const model::KinematicTree& tree, const model::FramePair& frames);

}  // namespace robcogen::algorithm
