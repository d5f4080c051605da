// Reads the shapes of links.
#pragma once

#include "import/shapes.h"
#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

// Reads the elements `visual` and `collision` that are asked for into the links of the document, which no longer counts
// them as ignored. Returns the files of meshes that were read.
std::vector<std::filesystem::path> read_shapes(
    const Element& root,
    const ShapeOptions& options,
    Document& document,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
