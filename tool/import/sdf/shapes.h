// Reads the shapes of links.
#pragma once

#include <optional>
#include <string>

#include "import/body_shape.h"
#include "import/sdf/element_reader.h"
#include "import/shapes.h"

namespace robcogen::import::from_sdf {

struct ReadShape {
  Name name;        // for messages
  ReadPose pose;    // of the element
  BodyShape shape;  // in the frame of the element
};

// Reads an element `visual` or `collision` of the link: nullopt for one that is not a shape, and for one that is left
// out. `meshes` is that of its document. Angles are not snapped: they cost no operations. Warns about a
// `collide_bitmask`.
std::optional<ReadShape> read_shape(
    const Element& element,
    const std::string& link,
    const ShapeOptions& options,
    ShapeMeshes& meshes,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_sdf
