// Sums of lanes two by two: together they take half as many instructions as one after the other.
#pragma once

#include "symbolic/program.h"

namespace robcogen::pass {

// The same statements in another order: of two sums of lanes that do not need each other, the second follows the first
// at once.
symbolic::Program pair_sums(symbolic::Program program);

}  // namespace robcogen::pass
