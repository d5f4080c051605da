// How large a robot is.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Of a link and all beyond it, with constants alone; what depends on parameters counts as one metre, or as nothing.
struct Extent {
  double length = 0.0;   // m: from the link's origin along the offsets of joints and centres of mass, the longest way
  double mass = 0.0;     // kg
  double inertia = 0.0;  // kg m^2: no less than any moment or product about the link's origin
};

// By link.
std::vector<Extent> extents(const KinematicTree& tree);

}  // namespace robcogen::model
