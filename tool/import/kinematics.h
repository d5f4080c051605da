// From documents to the model: names and expressions of the syntax get their meaning.
#pragma once

#include <optional>

#include "language/desired/document.h"
#include "language/kinematics/document.h"
#include "model/description.h"

namespace robcogen::import {

// What the document says, with parameters collected by where they stand. Reports names used in two kinds, bad arity of
// meaning (constants that are not finite), and the like.
model::Description describe(const language::kinematics::Document& document, Diagnostics& diagnostics);

// describe, then model::build.
std::optional<model::KinematicTree> kinematic_tree(
    const language::kinematics::Document& document,
    Diagnostics& diagnostics);

// Frames resolved against the robot. Lenient: a pair that names an unknown frame is skipped with a warning, as are
// duplicates, unlisted frames and a robot name that differs.
model::DesiredTransforms desired_transforms(
    const language::desired::Document& document,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics);

// The codes of the warnings of desired_transforms, which a strict reading makes errors.
const std::vector<std::string>& lenient_codes();

}  // namespace robcogen::import
