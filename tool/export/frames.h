// From the model to documents of motions and of coordinate transforms.
#pragma once

#include "language/motion/document.h"
#include "language/transforms/document.h"
#include "model/coordinate_transforms.h"

namespace robcogen::exporting {

// Lengths and angles that are parameters stand in groups `lengths` and `angles`; places mean nothing.
language::motion::Document motion_document(const model::RigidMotions& motions);
language::transforms::Document transforms_document(const model::CoordinateTransforms& transforms);

}  // namespace robcogen::exporting
