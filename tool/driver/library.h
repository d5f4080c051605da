// From a model and its functions to the input of the back ends.
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

// Whether transforms also come as products of primitives, and in which convention.
using Primitives = std::optional<model::MovedFramePosition>;

backend::Library library_of(
    const Model& model,
    const LibraryNames& names,
    std::vector<std::string> groups,
    Functions functions,
    Primitives primitives);

}  // namespace robcogen::driver
