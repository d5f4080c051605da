// The structure of the elimination in the joint-space inertia matrix, from the last row of an order to the first.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// The rows of H: a floating base's six, then coordinates.
struct EliminationTree {
  std::vector<int> order;  // ancestors first
  // By row: the rows that its elimination changes, directly or through others; nearest last. If no joint is coupled and
  // all rotors are on links that carry their joints, these are the coordinates of the joints that carry it
  // (Featherstone 2008, sec. 6.5). A coordinate that moves several branches ties them together, as does a rotor on
  // another branch. Then these are the ancestors in the elimination tree (Davis 2006, ch. 4), which cover all fill-in.
  std::vector<std::vector<int>> ancestors;
};

EliminationTree elimination_tree(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
