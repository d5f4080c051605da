// What inverse kinematics says about a chain.
#pragma once

#include <string>
#include <vector>

#include "algorithm/kinematics/inverse/calibration.h"
#include "algorithm/kinematics/inverse/plan.h"

namespace robcogen::algorithm::inversion {

// `J1 and J2 meet, J4, J5 and J6 meet in a point, J2 and J3 are parallel`
std::string describe_axes(const SerialChain& chain);

// `then 3 Newton steps on the chain itself, which find 97.1 % of random positions to 1e-9`
std::string describe(const Calibration& calibration);

// `8 branches; axes: …`, or why there is no closed form, with a hint. `arguments` are words for arguments with which
// the chain has one: `'given J7'`, `'swivel'`. `nominal`: the search with a tolerance, if there is another one.
// `needs_values`: the chain has a closed form with some values of its parameters only.
struct Explanation {
  std::string reason, hint;
};
Explanation explain(
    const Search& search,
    const std::vector<std::string>& arguments,
    const Search* nominal,
    bool needs_values);

}  // namespace robcogen::algorithm::inversion
