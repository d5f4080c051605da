// Sines in lanes that need no test for large angles.
#pragma once

#include "symbolic/program.h"

namespace robcogen::pass {

// Whether the program has sines or cosines in lanes, and robcogen::are_small for the joint positions implies that all
// of their angles are small: the angles are sums of at most three positions, some negated.
bool has_small_angles(const symbolic::Program& program);

}  // namespace robcogen::pass
