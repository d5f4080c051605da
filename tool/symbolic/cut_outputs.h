// Cuts a program by its outputs: stages that run one after the other, each of which computes some results, and stages
// that run when their results are needed. A caller that finds out early what it wanted to know skips the rest.
#pragma once

#include <array>
#include <vector>

#include "symbolic/stages.h"

namespace robcogen::symbolic {

// Elements of outputs: the output, and the place in its values.
using OutputElements = std::vector<std::array<int, 2>>;

// A stage that may run once the stages in turn up to `after`, that one included, have run.
struct StageOnDemand {
  OutputElements elements;
  int after = 0;
};

// The stages in turn, then those on demand. Stages in turn also compute what stages on demand share with them, as early
// as these may run, and pass it through the workspace, whose elements each have one value. Every result is that of the
// program, to the last bit. Programs with lanes are not cut.
Stages cut_outputs(
    const Program& program,
    const std::vector<OutputElements>& in_turn,
    const std::vector<StageOnDemand>& on_demand);

}  // namespace robcogen::symbolic
