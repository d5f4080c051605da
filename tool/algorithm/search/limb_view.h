// A robot reduced to the links that one joint moves or that carry it.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// The links between the base and a joint, and all beyond the joint, without user frames. `left_out`, by joint: whether
// the view lacks it and what it moves; the joint itself and those that carry it are never left out.
struct LimbView {
  model::KinematicTree tree;
  std::vector<int> joints;  // by joint of the view: the joint of the robot
};

LimbView limb_view(const model::KinematicTree& tree, int joint, const std::vector<bool>& left_out = {});

}  // namespace robcogen::algorithm
