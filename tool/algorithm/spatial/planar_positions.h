// Positions of the two dependent joints of a loop in a plane.
#pragma once

#include "algorithm/spatial/planar_loop.h"

namespace robcogen::algorithm {

// Returns `q` (by joint) with the positions of the dependent joints; `branch` as in model::Closure. If the loop
// cannot close, they are NaN.
std::vector<symbolic::Expression> closed_positions(
    symbolic::Graph& graph,
    const PlanarLoop& loop,
    double branch,
    std::vector<symbolic::Expression> q);

}  // namespace robcogen::algorithm
