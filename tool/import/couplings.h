// Converts the couplings of a robot document from expressions to sums over joints.
#pragma once

#include <vector>

#include "import/parameters.h"
#include "language/kinematics/document.h"
#include "model/description.h"

namespace robcogen::import {

// Reads the couplings of a document. A plain name is a joint, or a parameter that is declared elsewhere in the
// document; `rad` and `m` after a number are its unit, unless a joint or a parameter has that name. Reports expressions
// that are not linear in the joints, and factors without a unit between joints that turn and joints that slide.
std::vector<model::DescribedCoupling> read_couplings(
    const language::kinematics::Document& document,
    QuantityReader& reader,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
