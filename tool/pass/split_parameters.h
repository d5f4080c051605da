// Splits off from the programs of a parametric robot every value that depends on its parameters alone.
//
// Between two changes of the parameters, cosines of parametric angles, base inertial parameters, products of lengths
// and masses are constants. They are computed once, when the parameters change, into a cache that all programs read:
// the rest of a program costs as much as the program of a robot with constants.
#pragma once

#include <vector>

#include "symbolic/program.h"

namespace robcogen::pass {

struct SplitPrograms {
  // In the given order; their input array with the role `parameters` is now the cache, one array for all programs.
  std::vector<symbolic::Program> programs;
  // parameters -> a part of the cache. The first part depends on kinematics parameters only, the second one on dynamics
  // parameters only, the third one on parameters of both kinds, or on one that is of both. Each program has one output;
  // the outputs follow one another in the cache.
  symbolic::Program kinematics;
  symbolic::Program dynamics;
  symbolic::Program both;
};

// The interfaces that a parameter belongs to: one of them, or both.
struct Interfaces {
  bool kinematics = false;
  bool dynamics = false;
};

// `interfaces`: by parameter. Programs without an input with the role `parameters` stay as they are.
SplitPrograms split_parameters(std::vector<symbolic::Program> programs, const std::vector<Interfaces>& interfaces);

}  // namespace robcogen::pass
