// Reads the shapes of links.
#pragma once

#include <optional>
#include <string>

#include "import/body_shape.h"
#include "import/sdf/element_reader.h"
#include "import/shapes.h"

namespace robcogen::import::from_sdf {

// Reads an element `visual` or `collision` of the link, whose pose is not that of the element: nullopt for one that is
// not a shape, and for one that is left out. `meshes` is that of its document. Warns about a `collide_bitmask`.
std::optional<BodyShape> read_shape(
    const Element& element,
    const std::string& link,
    const ShapeOptions& options,
    ShapeMeshes& meshes,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_sdf
