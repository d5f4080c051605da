// From a document to the description of a model: lumps links on fixed joints, and turns frames to the axes of joints.
#pragma once

#include "import/urdf/names.h"
#include "import/urdf/topology.h"
#include "model/description.h"

namespace robcogen::import::from_urdf {

// Reports joints that the model does not have: floating joints except one below a massless root (a
// note), and joints that mimic what does not move; with `free_mimic_joints` one note on all that mimic others.
void check_joints(const Document& document, const Topology& topology, bool free_mimic_joints, Diagnostics& diagnostics);

// `limits` are those of each joint of the document. Joints that mimic others are coupled, unless they are free.
model::Description describe(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const std::vector<model::JointLimits>& limits,
    bool floating_base,
    bool free_mimic_joints);

}  // namespace robcogen::import::from_urdf
