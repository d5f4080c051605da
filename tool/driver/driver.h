// The generator as a library: from a model to the files of its code.
//
//     load -> declare -> choose -> variants -> assemble -> print
//
// Each phase is a function from one value to the next (load.h, declare.h, formulations.h, candidates.h, optimise.h,
// library.h, backend/languages.h).
// Robots and documents of coordinate transforms pass through the same phases.
#pragma once

#include <string>
#include <vector>

#include "driver/declare.h"
#include "driver/library.h"
#include "driver/load.h"
#include "driver/steps.h"

namespace robcogen::driver {

// The functions of these groups as programs, after these steps, in the forms that a language takes.
Functions programs(
    const Model& model,
    const std::vector<std::string>& groups,
    const Steps& steps,
    const backend::Features& features = {});

// The contents of a library.
struct LibraryOptions {
  LibraryNames names;
  std::vector<std::string> groups;  // for robots
  Steps steps = {};
  Primitives primitives = std::nullopt;
  bool has_batches = false;
  std::vector<std::string> levels = {};  // processors in addition to the baseline
  bool has_single_precision = false;
};

backend::Library library(const Model& model, const LibraryOptions& options, const backend::Features& features = {});

}  // namespace robcogen::driver
