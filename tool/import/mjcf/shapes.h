// Reads the shapes of bodies: geoms.
#pragma once

#include "import/mjcf/document.h"

namespace robcogen::import::from_mjcf {

// Reads the geoms of the robot, which are then not counted as ignored. MuJoCo shows those of the groups 0 to 2, and
// checks those that have bits of `contype` or `conaffinity`. Planes and height fields are left out; one
// that would be checked causes a warning.
void read_shapes(Document& document, const ShapeOptions& options, const Context& context);

// Reads which pairs of bodies are not checked, from the elements `exclude` of the section `contact`. Warns about bodies
// that the document does not have, and about pairs of geoms, which have no counterpart.
void read_excludes(const Element& section, Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
