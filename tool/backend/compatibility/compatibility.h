// The headers of the first RobCoGen, so that programs that were written for it compile: thin classes over the kernels
// of the library in C++. What does not depend on the robot is in <robcogen/compatibility/…>.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"
#include "support/diagnostics.h"

namespace robcogen::backend::compatibility {

struct Options {
  std::string space;         // `iit::HyQ`; empty: `iit::` and the name of the robot
  std::string include_path;  // folder of the headers
};

// `iit/robots/hyq`, where the first RobCoGen installed the headers of HyQ.
std::string default_include_path(const std::string& name);

// The groups of functions that the headers call.
const std::vector<std::string>& groups();

// Reports each joint whose type the first RobCoGen does not have, and each name that its enumerations would repeat.
void check(const model::KinematicTree& tree, Diagnostics& diagnostics);

// Adds the transforms between each link and its parent, which the first RobCoGen made without being asked.
void add_link_transforms(const model::KinematicTree& tree, model::DesiredTransforms& desired);

// The paths of the files, for a library with this folder. `print` returns these files.
std::vector<std::string> outputs(const std::string& library_folder, const std::string& include_path);
std::vector<OutputFile> print(const Library& library, const Options& options);

}  // namespace robcogen::backend::compatibility
