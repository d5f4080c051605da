// Forces as expressions, for algorithms that go on from them.
#pragma once

#include <vector>

#include "algorithm/setup.h"

namespace robcogen::algorithm {

struct Forces {
  std::vector<Expression> tau;  // by joint
  Spatial base_wrench;          // of a floating base
};

// At zero joint and base acceleration, by recursive Newton-Euler (Featherstone 2008, table 5.1).
Forces bias_forces(
    const Setup& setup,
    const std::vector<Expression>& qd,
    const Spatial& base_velocity,
    const LoadInputs& loads);

}  // namespace robcogen::algorithm
