// Converts robot documents to the model: resolves names and evaluates expressions.
#pragma once

#include <optional>

#include "language/desired/document.h"
#include "language/kinematics/document.h"
#include "model/changes.h"
#include "model/compound.h"
#include "model/description.h"

namespace robcogen::import {

// The type of a joint with one coordinate.
model::JointType type_of(language::kinematics::Joint::Type type);
// The type of a joint with several coordinates; nullopt for a joint with one.
std::optional<model::CompoundType> compound_type_of(language::kinematics::Joint::Type type);

// Returns the robot of the document and its parameters, whose kind follows from where they are used. Reports errors in
// expressions, such as constants that are not finite, and parameters of two kinds.
model::Description describe(const language::kinematics::Document& document, Diagnostics& diagnostics);

// Calls describe, then model::build.
std::optional<model::KinematicTree> kinematic_tree(
    const language::kinematics::Document& document,
    const model::Changes& changes,
    Diagnostics& diagnostics);
std::optional<model::KinematicTree> kinematic_tree(
    const language::kinematics::Document& document,
    Diagnostics& diagnostics);

// Resolves the frames of the list; functions are not checked. A pair with an unknown frame is skipped with a warning.
// Duplicates, unlisted frames and a different robot name are warnings too.
model::DesiredTransforms desired_transforms(
    const language::desired::Document& document,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics);

// The functions as they are written, with the places of their names.
std::vector<model::FusedFunction> fused_functions(
    const std::vector<language::desired::Function>& functions,
    const std::shared_ptr<const Source>& source);

// A contact frame by name.
struct NamedContact {
  std::string frame;
  bool is_surface = false;
  Place place;
};

// Unknown frames, frames of a fixed base and repetitions are errors, because the list determines the rows of the
// contact functions.
std::vector<model::ContactFrame> contact_frames(
    const std::vector<NamedContact>& names,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics);

// Inverse kinematics by names.
struct NamedInverse {
  std::string left, right;
  model::InverseTask::Kind kind = model::InverseTask::Kind::pose;
  bool by_swivel = false;
  std::string given = {};  // a joint, or empty
  std::optional<double> tolerance = {};
  Place place = {};
};

// Unknown frames and joints, repeated pairs and tolerances that cannot be are errors.
std::vector<model::InverseTarget> inverse_targets(
    const std::vector<NamedInverse>& names,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics);

// The codes of the warnings of desired_transforms, which strict mode turns into errors.
const std::vector<std::string>& lenient_codes();

}  // namespace robcogen::import
