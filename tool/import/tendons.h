// Converts the tendons of a robot document.
#pragma once

#include <vector>

#include "import/parameters.h"
#include "language/kinematics/document.h"
#include "model/description.h"

namespace robcogen::import {

// Names in a length have the same meaning as in couplings. A constant in a length becomes part of the rest length.
// Reports lengths that are not linear in the joints, and those that add radians and metres.
std::vector<model::DescribedTendon> read_tendons(
    const language::kinematics::Document& document,
    QuantityReader& reader,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
