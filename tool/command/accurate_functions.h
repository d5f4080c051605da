// The functions of a robot after the passes, none with rounding errors much above those of the plain recursions.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "symbolic/accuracy.h"

namespace robcogen::command {

struct AccurateFunction {
  algorithm::RobotFunction function;  // with its rounding errors
  std::shared_ptr<const symbolic::AccurateResults> results;
  bool is_as_traced = true;  // by the formulation that was given; else by a simpler one
};

// Runs the passes on functions that were traced with this formulation, group by group. A function that loses more than
// that of the plain formulation is traced again: without the search for frames, then plainly, then without passes.
std::vector<AccurateFunction> accurate_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::vector<std::string>& groups,
    std::vector<std::vector<algorithm::RobotFunction>> of_groups,
    const algorithm::Formulation& formulation,
    const std::vector<std::string>& passes);

}  // namespace robcogen::command
