// The same machine described in another way. Placements become plain numbers on the way; inertias stay in link frames.
#pragma once

#include "model/kinematic_tree.h"
#include "robcogen/reference/algebra.h"

namespace robcogen::numeric {

// Exact enough that differences are due to the rounding of the programs.
using Pose = reference::Matrix<long double>;

Pose pose_of(const model::Placement& placement);
model::Placement placement_of(const Pose& pose);

// Declares links and joints in another order: position k of the new robot holds the element at order[k]. The base stays
// first.
model::KinematicTree reordered(
    const model::KinematicTree& robot,
    const std::vector<int>& link_order,
    const std::vector<int>& joint_order);

// Names every link, joint and frame anew.
model::KinematicTree renamed(const model::KinematicTree& robot);

// Slides each link frame along its joint's axis and turns it about it, by amounts of its own. Joint positions keep
// their meaning, wrenches on links change their frame: new_X_old of each link is returned with the robot.
struct Reframed {
  model::KinematicTree robot;
  std::vector<Pose> new_X_old;
};
Reframed reframed(const model::KinematicTree& robot);

// Seen in a mirror: y becomes -y everywhere. Joints turn the other way, but slide as before: screws are of the other
// hand.
model::KinematicTree mirrored(const model::KinematicTree& robot);

// Welds a joint at a position: its child becomes a part of its parent. Links and joints beyond move up by one place.
model::KinematicTree with_locked_joint(const model::KinematicTree& robot, int joint, double position);

}  // namespace robcogen::numeric
