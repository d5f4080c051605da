// A kinematic tree as reflection tables, for the reference. Mass properties are moved to the link frame by separate
// formulas, because a test that shares the model's formulas cannot find errors in them.
#pragma once

#include <span>

#include "../reference/tables.h"
#include "model/kinematic_tree.h"

namespace robcogen::numeric {

// Links, joints and all frames that have names, in the tree's order; `parameters` are values of the tree's parameters.
reference::Tables reference_tables(const model::KinematicTree& robot, std::span<const double> parameters = {});

// The index of a frame in those tables.
int frame_index(const model::KinematicTree& robot, const model::Frame& frame);

}  // namespace robcogen::numeric
