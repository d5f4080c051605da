// Forward dynamics by articulated bodies, as expressions.
#pragma once

#include <vector>

#include "algorithm/setup.h"

namespace robcogen::algorithm {

struct ForwardInputs {
  std::vector<Expression> qd, tau;  // by joint
  Spatial base_velocity;            // of a floating base
};

struct ForwardMotion {
  std::vector<Expression> qdd;
  Spatial base_acceleration;
};

// Featherstone 2008, table 7.1, split into bias forces and a homogeneous part.
ForwardMotion by_articulated_bodies(const Setup& setup, const ForwardInputs& in, const LoadInputs& load);

}  // namespace robcogen::algorithm
