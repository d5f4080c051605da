// The program with lanes that a plan describes.
#pragma once

#include <vector>

#include "pass/lanes/lane_builder.h"
#include "pass/lanes/lane_plan.h"

namespace robcogen::pass {

// `signs`: the result of plan_signs. Constants may differ from lane to lane and absorb the signs in which limbs differ.
// `builder`: a new LaneBuilder for this program.
symbolic::Program lane_program(
    const symbolic::Program& program,
    const LanePlan& plan,
    const std::vector<unsigned>& signs,
    LaneBuilder& builder);

}  // namespace robcogen::pass
