// Passes, for as long as they keep the digits of the plain recursions.
#pragma once

#include <string>
#include <vector>

#include "driver/functions.h"
#include "driver/load.h"

namespace robcogen::driver {

// Runs the passes on the functions of a robot that were traced with this formulation, and measures their rounding
// errors. A function that loses more than that of the plain formulation is traced again: without the search for frames,
// then plainly, then without passes. Its program for congruent limbs is dropped then.
Functions run_accurate_passes(
    const Robot& robot,
    Functions traced,
    const algorithm::Formulation& formulation,
    const std::vector<std::string>& passes);

}  // namespace robcogen::driver
