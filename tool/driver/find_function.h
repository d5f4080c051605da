// Finds the functions of a model by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "driver/load.h"

namespace robcogen::driver {

// The name of a function on the command line and in messages: `transforms.homogeneous.A_X_B`.
std::string dotted(const std::string& scope, const std::string& name);

struct FoundFunctions {
  std::vector<algorithm::RobotFunction> overloads;  // of that name, fewest arguments first; empty: none
  std::vector<std::string> names;                   // if there are none: the functions that the robot has
};

// The functions of a robot with this name, which may be between frames that its list of desired transforms does not
// have.
FoundFunctions find_functions(const Robot& robot, const std::string& name, algorithm::FormulationChoices& formulations);

// Throws a Failure for a name that no function of `owner`, such as `robot 'HyL'`, has; `names` are the existing names.
[[noreturn]] void refuse_function(
    const std::string& owner,
    const std::filesystem::path& model,
    const std::string& name,
    const std::vector<std::string>& names);

}  // namespace robcogen::driver
