// The C++ back end: Eigen wrappers over Eigen-free kernels, readable and warning-free.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend::cpp {

// The folder of a library's files: its name, below a folder for each enclosing namespace (`a::b`), so that libraries of
// one name in different namespaces go into one program.
std::string folder(const std::string& name, const std::string& enclosing);

// The names of the files that `print` makes in this folder, relative to the output directory: a function of the
// keywords only.
std::vector<std::string> outputs(
    const std::string& folder,
    const std::vector<std::string>& groups,
    bool has_robot = true,
    bool has_batches = false,
    const std::vector<std::string>& levels = {});

std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::cpp
