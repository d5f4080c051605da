// From the model to documents of motions and of coordinate transforms.
#pragma once

#include "language/motion/document.h"
#include "language/transforms/document.h"
#include "model/coordinate_transforms.h"

namespace robcogen::exporting {

// Parameters are in groups `lengths` and `angles`. Places are not set.
language::motion::Document motion_document(const model::RigidMotions& motions);
language::transforms::Document transforms_document(const model::CoordinateTransforms& transforms);

}  // namespace robcogen::exporting
