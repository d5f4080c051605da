// Upper bounds on the size of a robot.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Bounds for a link and its subtree, from constants only: a length that depends on parameters counts as one metre, and
// a mass that does as zero.
struct Extent {
  double length = 0.0;   // m: longest path from the link's origin along the offsets of joints and centres of mass
  double mass = 0.0;     // kg
  double inertia = 0.0;  // kg m^2: bound on any moment or product about the link's origin
};

// Returns the extents by link.
std::vector<Extent> extents(const KinematicTree& tree);

}  // namespace robcogen::model
