// Other descriptions of the same machine. Placements become plain numbers; inertias stay in link frames.
#pragma once

#include "model/kinematic_tree.h"
#include "robcogen/reference/algebra.h"

namespace robcogen::numeric {

// Exact enough that differences come from the rounding of the programs.
using Pose = reference::Matrix<long double>;

Pose pose_of(const model::Placement& placement);
model::Placement placement_of(const Pose& pose);

// Declares links and joints in another order: position k of the new robot holds the element at order[k]. The base stays
// first.
model::KinematicTree reordered(
    const model::KinematicTree& robot,
    const std::vector<int>& link_order,
    const std::vector<int>& joint_order);

// Renames every link, joint and frame.
model::KinematicTree renamed(const model::KinematicTree& robot);

// Moves each link frame along its joint's axis and rotates it about the axis, each by a different amount. Joint
// positions keep their meaning; wrenches on links change their frame, so new_X_old of each link is returned with the
// robot.
struct Reframed {
  model::KinematicTree robot;
  std::vector<Pose> new_X_old;
};
Reframed reframed(const model::KinematicTree& robot);

// The mirror image: y becomes -y everywhere. Joints turn the other way but slide as before, so screws change their
// hand.
model::KinematicTree mirrored(const model::KinematicTree& robot);

// Welds a joint at a position: its child becomes a part of its parent. Later links and joints move up by one index.
model::KinematicTree with_locked_joint(const model::KinematicTree& robot, int joint, double position);

}  // namespace robcogen::numeric
