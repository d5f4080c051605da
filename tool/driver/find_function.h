// Finds the functions of a model by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "algorithm/catalogue/find.h"
#include "driver/load.h"

namespace robcogen::driver {

// The name of a function on the command line and in messages: `transforms.homogeneous.A_X_B`.
using algorithm::dotted;

// The functions of a robot with this name, fewest arguments first. They may be between frames that its list of desired
// transforms does not have.
std::vector<algorithm::Declared> find_functions(const Robot& robot, const std::string& name);

// The names of the functions that the robot has.
std::vector<std::string> function_names(const Robot& robot);

// Throws a Failure for a name that no function of `owner`, such as `robot 'HyL'`, has; `names` are the existing names.
[[noreturn]] void refuse_function(
    const std::string& owner,
    const std::filesystem::path& model,
    const std::string& name,
    const std::vector<std::string>& names);

}  // namespace robcogen::driver
