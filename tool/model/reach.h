// Upper bounds of the size of a robot.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Of a link and its subtree, from constants only: a length that depends on parameters counts as one metre, a mass as
// zero.
struct Extent {
  double length = 0.0;   // m: from the link's origin along the offsets of joints and centres of mass, the longest path
  double mass = 0.0;     // kg
  double inertia = 0.0;  // kg m^2: at least any moment or product about the link's origin
};

// By link.
std::vector<Extent> extents(const KinematicTree& tree);

}  // namespace robcogen::model
