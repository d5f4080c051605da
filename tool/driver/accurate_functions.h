// Runs passes, as long as they keep the accuracy of the plain recursions.
#pragma once

#include <string>
#include <vector>

#include "driver/functions.h"
#include "driver/load.h"

namespace robcogen::driver {

// Runs the passes on the functions of a robot that were traced with this formulation, and measures their rounding
// errors. If a function loses more digits than the plain formulation, it is replaced by the cheaper of two others that
// do not: the same without the pass that reorders sums, and the one traced without the search for frames. If both lose
// digits, it is traced plainly, and at last plainly without passes. Its program for congruent limbs is then dropped.
Functions run_accurate_passes(
    const Robot& robot,
    Functions traced,
    const algorithm::Formulation& formulation,
    const std::vector<std::string>& passes);

}  // namespace robcogen::driver
