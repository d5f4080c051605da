// The places of the spheres of a robot, for a check that ends early.
#pragma once

#include <string>

#include "model/collision_tree.h"
#include "symbolic/program.h"
#include "symbolic/stages.h"

namespace robcogen::algorithm {

// q -> links, bodies, spheres: the centres (m) of the spheres of a collision tree, in the base, a column for each.
symbolic::Program collision_check(
    const model::KinematicTree& tree,
    const model::CollisionTree& shapes,
    const std::string& name);

// That program, or one that passes made of it, in stages: one for each link in turn, which places the sphere around it;
// then one for each link, on demand, which places those of its bodies and of its shapes.
symbolic::Stages in_stages(const symbolic::Program& program, const model::CollisionTree& shapes);

}  // namespace robcogen::algorithm
