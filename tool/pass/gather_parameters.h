// Values that depend on parameters alone are constant between two changes of the parameters, and fold like constants.
#pragma once

#include "symbolic/program.h"

namespace robcogen::pass {

// Applies the folding rules of constants to every value that depends on parameters alone: k1 (k2 x) becomes (k1 k2) x,
// k1 x + k2 x becomes (k1 + k2) x, (x + k1) + k2 becomes x + (k1 + k2). The total number of operations may grow,
// because the operations on parameters are not yet split off.
symbolic::Program gather_parameters(const symbolic::Program& program);

}  // namespace robcogen::pass
