// The self-check of a generated library: it compares random states with the independent reference, and checks
// identities that hold for every robot.
#pragma once

#include <vector>

#include "robcogen/level.h"
#include "robcogen/reference/any_subject.h"
#include "robcogen/reference/checks.h"
#include "robcogen/reflection.h"

namespace robcogen::reference {

// What the checks need of a library. `values` are those of the robot's parameters, and empty if it has none.
struct Library {
  const Robot* robot = nullptr;
  // `tables` are those of the robot with these values, and outlive the subject.
  AnySubject (*subject)(const Robot& tables, const std::vector<double>& values) = nullptr;
  // The same in single precision, for a robot without parameters; nullptr if the library has no such functions.
  AnySubject (*single)(const Robot& tables) = nullptr;
  // The first input of kernels; empty if the robot has no parameters.
  std::vector<double> (*cache)(const std::vector<double>& values) = nullptr;
  // Checks parameters that are updated from `before` to `after`; nullptr if the robot has none.
  void (*check_updates)(
      const Robot& robot,
      const std::vector<double>& after,
      const std::vector<double>& before,
      Checks& checks,
      int sample) = nullptr;
  const reflection::BatchFunctions* batch_functions = nullptr;  // nullptr if the library has none
  void (*use_level)(Level) = nullptr;                           // nullptr if it has kernels for one processor
};

// The program `[--seed N] [--samples N]`: prints one line per check. Returns 0 if all passed, 1 if one failed, 2 if the
// command line is wrong, 77 if no values were found for the parameters. A robot with parameters is checked with several
// sets of values.
int selfcheck(const Library& library, int argc, char** argv);

}  // namespace robcogen::reference
