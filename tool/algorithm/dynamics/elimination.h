// The structure of an elimination in the joint-space inertia matrix, from the last row of an order to the first.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// The rows of H: a floating base's six, then coordinates.
struct EliminationTree {
  std::vector<int> order;  // ancestors first
  // By row: the rows that its elimination changes, or that change by it in turn; nearest last. Where no joint is
  // coupled and rotors are on links that carry their joints, the coordinates of the joints that carry it (Featherstone
  // 2008, sec. 6.5). A coordinate that moves several branches ties them, as a rotor on another branch does: then those
  // of the elimination tree (Davis 2006, ch. 4), which holds all that is filled in.
  std::vector<std::vector<int>> ancestors;
};

EliminationTree elimination_tree(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
