// From robot documents to the model: resolves names and evaluates expressions.
#pragma once

#include <optional>

#include "language/desired/document.h"
#include "language/kinematics/document.h"
#include "model/compound.h"
#include "model/description.h"

namespace robcogen::import {

// Of a joint of one coordinate.
model::JointType type_of(language::kinematics::Joint::Type type);
// Of one of several.
std::optional<model::CompoundType> compound_type_of(language::kinematics::Joint::Type type);

// The robot of the document, with its parameters, whose kind follows from where they stand. Reports errors in
// expressions, such as constants that are not finite, and parameters of two kinds.
model::Description describe(const language::kinematics::Document& document, Diagnostics& diagnostics);

// describe, then model::build.
std::optional<model::KinematicTree> kinematic_tree(
    const language::kinematics::Document& document,
    Diagnostics& diagnostics);

// Resolves the frames of the list. A pair with an unknown frame is skipped with a warning. Duplicates, unlisted frames
// and another robot name are warnings.
model::DesiredTransforms desired_transforms(
    const language::desired::Document& document,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics);

// A contact frame by name.
struct NamedContact {
  std::string frame;
  bool is_surface = false;
  Place place;
};

// Unknown frames, frames of a fixed base and repetitions are errors: the rows of contacts follow from the list.
std::vector<model::ContactFrame> contact_frames(
    const std::vector<NamedContact>& names,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics);

// The codes of the warnings of desired_transforms, which a strict reading makes errors.
const std::vector<std::string>& lenient_codes();

}  // namespace robcogen::import
