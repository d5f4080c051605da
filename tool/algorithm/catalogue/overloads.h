// How the functions of a group are put together.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"

namespace robcogen::algorithm {

// Sets how the functions with this name are computed.
void add_method(std::vector<RobotFunction>& list, const std::string& name, const std::string& method);

using Build = std::function<symbolic::Program(const std::string& kernel, Loads loads)>;

// The overloads of one function. With a floating base gravity is always an argument, because it tells the orientation
// of the base.
void add_overloads(
    std::vector<RobotFunction>& list,
    const model::KinematicTree& tree,
    const std::string& group,
    const std::string& name,
    std::vector<std::string> summary,
    const Build& build,
    bool takes_external = true);

// The loads of a program, from its inputs.
Loads loads_of(const symbolic::Program& program);

// Adds to derivatives with external wrenches what is constant.
void add_wrenches_remark(std::vector<RobotFunction>& list);

}  // namespace robcogen::algorithm
