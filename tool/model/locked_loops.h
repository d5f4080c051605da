// Loops some of whose joints are locked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Loops that share joints, directly or through couplings, as they are when some of their joints are locked.
struct LockedGroup {
  std::vector<int> loops;
  std::vector<int> joints;        // that are not locked and follow no coupling
  std::vector<int> locked;        // that are locked and follow no coupling
  std::vector<double> positions;  // of all joints of the tree (rad, m), where the loops are closed
  double gap = 0.0;               // m; how far the loops remain open
  bool is_closed = false;
  bool is_rigid = false;  // the joints cannot move either
  int freedoms = 0;       // of the joints
};

// `tree` is a tree with loops, and `open` the same with only those couplings that the document declares. `start` are
// the positions of all joints where its loops are closed; `targets`, by joint, are the positions of locked joints. The
// joints are moved there along a straight line. Groups without locked joints are left out.
std::vector<LockedGroup> locked_groups(
    const KinematicTree& tree,
    const KinematicTree& open,
    const std::vector<double>& start,
    const std::vector<std::optional<double>>& targets,
    const std::vector<double>& parameters);

}  // namespace robcogen::model
