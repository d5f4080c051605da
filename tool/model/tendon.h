// Tendons: springs and dampers between joints. The length of a tendon is a sum of joint positions.
#pragma once

#include <string>
#include <vector>

#include "model/quantity.h"

namespace robcogen::model {

// With the length l = sum of factor * q_j, the force k (l - rest) + d dl/dt resists a change of the length, so that
// joint j must overcome the factor times it. The transmission of a series-elastic joint has the length motor - joint
// (Spong 1987).
struct Tendon {
  struct Term {
    int joint = -1;   // independent or coupled; not spherical
    Quantity factor;  // not the constant zero
  };
  std::string name;
  std::vector<Term> terms;  // by joint, each joint once
  Quantity stiffness;       // k: N/m or N m, for lengths in m or rad
  Quantity damping;         // d: N s/m or N m s
  Quantity rest;            // m or rad
  Place place;
};

}  // namespace robcogen::model
