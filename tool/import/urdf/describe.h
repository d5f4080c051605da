// From a document to the description of a model: fixed joints are lumped, frames are turned to the joints' axes.
#pragma once

#include "import/urdf/names.h"
#include "import/urdf/topology.h"
#include "model/description.h"

namespace robcogen::import::from_urdf {

// Whether the model has such joints. Reports planar joints, floating ones but the first below a massless root (that one
// is noted), and joints that mimic others: as errors, or, when they are free, in a note.
void check_joints(const Document& document, const Topology& topology, bool free_mimic_joints, Diagnostics& diagnostics);

// `limits` are those of each joint of the document.
model::Description describe(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const std::vector<model::JointLimits>& limits,
    bool floating_base);

}  // namespace robcogen::import::from_urdf
