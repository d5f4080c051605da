// With which signs the values of lanes are kept.
#pragma once

#include <vector>

#include "pass/lanes/lane_plan.h"

namespace robcogen::pass {

// By value of lanes: the lanes that are kept negated, a bit each, so that few have to be changed where limbs are
// mirrored. Values that outputs ask for are kept as they are, up to a sign of the whole.
std::vector<unsigned> plan_signs(const LanePlan& plan);

}  // namespace robcogen::pass
