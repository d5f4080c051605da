// Converts documents of rigid motions and of coordinate transforms to the model.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "language/desired/document.h"
#include "language/motion/document.h"
#include "language/transforms/document.h"
#include "model/coordinate_transforms.h"

namespace robcogen::import {

// Reports frames that are not in the document's list, motions from a frame to itself, pairs of frames with two motions,
// and motions that close a loop. nullopt if an error was reported.
std::optional<model::RigidMotions> rigid_motions(const language::motion::Document& document, Diagnostics& diagnostics);

// Reports frames that are not in the document's list, transforms from a frame to itself, and pairs that are given
// twice. nullopt if an error was reported.
std::optional<model::CoordinateTransforms> coordinate_transforms(
    const language::transforms::Document& document,
    Diagnostics& diagnostics);

using model::FrameNames;

// Returns the pairs of frames for which a list requests transforms, without duplicates. As lenient as
// desired_transforms (import/kinematics.h). Frames that no motions connect are an error, and so are Jacobians, because
// they need joints.
std::vector<FrameNames> desired_frame_pairs(
    const language::desired::Document& document,
    const model::RigidMotions& motions,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
