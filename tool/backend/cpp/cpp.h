// The C++ back end: Eigen wrappers over Eigen-free kernels, readable and warning-free.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend::cpp {

// The folder of a library's files: its name, below one folder for each enclosing namespace (`a::b`), so that libraries
// of the same name in different namespaces can go into one program.
std::string folder(const std::string& name, const std::string& enclosing);

// The files that `print` makes in this folder, as paths relative to the output directory. They depend on the arguments
// alone.
std::vector<std::string> outputs(
    const std::string& folder,
    const std::vector<std::string>& groups,
    bool has_robot = true,
    bool has_batches = false,
    const std::vector<std::string>& levels = {});

std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::cpp
