// Coordinate transforms with no robot: from documents of motions or of transforms to libraries.
#pragma once

#include "algorithm/catalogue/transform_functions.h"
#include "command/pipeline.h"

namespace robcogen::command {

// Transforms as loaded from their documents: those that a list asks for, or all that the document names.
struct Transforms {
  model::CoordinateTransforms document;
  std::string canonical;                    // all that the model says, in one form whatever its layout was
  std::filesystem::path model;              // as given
  std::vector<std::filesystem::path> read;  // every file that was read
};

bool is_motions(const std::filesystem::path& model);
// Documents of motions too: transforms are made of them.
bool is_transforms(const std::filesystem::path& model);

// The frames of a document of motions or of transforms, and the ways between them. nullopt when an error was reported.
std::optional<model::RigidMotions> load_motions_of(const std::filesystem::path& model, Diagnostics& diagnostics);

// Without a list: of motions each and its inverse, of transforms all. nullopt when an error was reported.
std::optional<Transforms> load_transforms(
    const std::filesystem::path& model,
    const Reading& reading,
    Diagnostics& diagnostics);

// All functions, by these steps.
std::vector<algorithm::TransformFunction> trace(const Transforms& transforms, const Steps& steps);

// The only group of functions that such a library has.
inline constexpr const char* kTransformsGroup = "transforms";

// What the back ends print.
backend::Library library(
    const Transforms& transforms,
    const LibraryNames& names,
    const Steps& steps,
    Primitives primitives = std::nullopt);

}  // namespace robcogen::command
