// The places of the spheres of a robot, for a check that ends early.
#pragma once

#include <string>

#include "model/collision_tree.h"
#include "symbolic/program.h"
#include "symbolic/stages.h"

namespace robcogen::algorithm {

// q -> parts, groups, spheres: the centres (m) of the spheres of a collision tree, in the base, a column for each.
symbolic::Program collision_check(
    const model::KinematicTree& tree,
    const model::CollisionTree& shapes,
    const std::string& name);

// That program, or one that passes made of it, in stages: one that places the spheres around all parts, which takes less
// time than to find out after each link whether another one is needed; then on demand, in this order, one for each part
// with several groups, which places those, and one for each group with several spheres. What contains one member alone
// is placed where this is.
symbolic::Stages in_stages(const symbolic::Program& program, const model::CollisionTree& shapes);

}  // namespace robcogen::algorithm
