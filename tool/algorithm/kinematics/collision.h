// Collision shapes of a robot in the base, and the distance between them.
#pragma once

#include <string>

#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// q -> centers, radii: the centres (m) of the collision shapes that are spheres, in the base, a column for each; and
// their radii (m), which are constant.
symbolic::Program collision_spheres(const model::KinematicTree& tree, const std::string& name);

// q -> ends, radii: the same for all other shapes (model/collision.h): six rows, the two ends of the axis (m).
symbolic::Program collision_capsules(const model::KinematicTree& tree, const std::string& name);

// q -> distance: the smallest distance (m) between capsules whose pair is checked (model::collision_pairs), negative
// where their axes are nearer than their radii allow.
//
// The program has no branches and no other operations than those of dynamics: |x| is the root of x^2 + 1e-36 m^2, which
// is |x| after rounding, except below 1e-10 m, where its derivative is that of a smooth function and never undefined.
// The points of two segments are those of Ericson (2005, sec. 5.1.9). Where the axes of two capsules are nearly
// parallel, to 1e-3 rad, the distance may be too large by 5e-7 of the product of their lengths, divided by itself.
symbolic::Program self_distance(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::algorithm
