// From documents of motions and of coordinate transforms to the model.
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
// and motions that close a loop. nullopt when an error was reported.
std::optional<model::RigidMotions> rigid_motions(const language::motion::Document& document, Diagnostics& diagnostics);

// Reports frames that are not in the document's list, transforms from a frame to itself, and pairs that are given
// twice. nullopt when an error was reported.
std::optional<model::CoordinateTransforms> coordinate_transforms(
    const language::transforms::Document& document,
    Diagnostics& diagnostics);

using model::FrameNames;

// The transforms between frames of motions that a list asks for, each once. As lenient as desired_transforms
// (import/kinematics.h). Frames that no motions connect are an error, and so are Jacobians: they need joints.
std::vector<FrameNames> desired_frame_pairs(
    const language::desired::Document& document,
    const model::RigidMotions& motions,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
