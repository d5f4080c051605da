// From a model and its functions to what the back ends print.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/functions.h"
#include "driver/load.h"

namespace robcogen::driver {

inline constexpr const char* kVersion = ROBCOGEN_VERSION;

struct LibraryNames {
  std::string name;            // folder and namespace
  std::string enclosing = {};  // namespace around it, or empty
};

// Whether transforms come as products of primitives too, and of which convention.
using Primitives = std::optional<model::MovedFramePosition>;

backend::Library assemble(
    const Model& model,
    const LibraryNames& names,
    std::vector<std::string> groups,
    Functions functions,
    Primitives primitives);

}  // namespace robcogen::driver
