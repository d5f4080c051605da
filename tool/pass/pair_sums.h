// Puts sums over lanes in pairs: the two sums of a pair share their instructions, which halves their cost.
#pragma once

#include "symbolic/program.h"

namespace robcogen::pass {

// Reorders the statements: of two sums over lanes that do not depend on each other, the second directly follows the
// first.
symbolic::Program pair_sums(symbolic::Program program);

}  // namespace robcogen::pass
