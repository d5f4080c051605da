// What follows from parameters alone is a constant between two of their changes, and folds like one.
#pragma once

#include "symbolic/program.h"

namespace robcogen::pass {

// Applies the rules by which constants fold to all that follows from the parameters alone: k1 (k2 x) becomes (k1 k2) x,
// k1 x + k2 x becomes (k1 + k2) x, (x + k1) + k2 becomes x + (k1 + k2). The number of operations may grow as long as
// those on parameters count.
symbolic::Program gather_parameters(const symbolic::Program& program);

}  // namespace robcogen::pass
