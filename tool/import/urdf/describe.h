// From a document to the description of a model: lumps links on fixed joints, and turns frames to the axes of joints.
#pragma once

#include "import/pose.h"
#include "import/urdf/names.h"
#include "import/urdf/topology.h"
#include "model/description.h"

namespace robcogen::import::from_urdf {

// Reports joints that the model does not have: floating joints except one below a massless root (a
// note), and joints that mimic what does not move; with `free_mimic_joints` one note on all that mimic others.
void check_joints(const Document& document, const Topology& topology, bool free_mimic_joints, Diagnostics& diagnostics);

// The pose of a link's URDF frame in the model's frame of the link that carries it.
struct Carried {
  int body = -1;  // a link; -1 for a root that is left out
  Pose pose;
};

// By link of the document.
std::vector<Carried> carry(const Document& document, const Topology& topology);

// `limits` are those of each joint of the document. Joints that mimic others are coupled, unless they are free.
model::Description describe(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const std::vector<model::JointLimits>& limits,
    bool floating_base,
    bool free_mimic_joints);

// Adds loops, couplings and independent joints. A loop's frames are user frames `<loop>_predecessor` and
// `<loop>_successor`, whose z axes are that of the loop. Joints with `independent="false"` follow, if there are any;
// all others of a loop or a coupling lead. Reports links that do not exist, types of loops that are not served, and
// couplings that do not say how a joint follows.
void add_loops(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
