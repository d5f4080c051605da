// The signs with which packed values are kept.
#pragma once

#include <vector>

#include "pass/lanes/lane_plan.h"

namespace robcogen::pass {

// By packed value: the lanes that are kept negated, a bit for each, so that few signs change between mirrored limbs.
// Values that outputs read are kept as they are, up to one sign for all lanes.
std::vector<unsigned> plan_signs(const LanePlan& plan);

}  // namespace robcogen::pass
