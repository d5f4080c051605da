// Converts a document to the description of a model: lumps links on fixed joints, and aligns frames with the joint
// axes.
#pragma once

#include "import/pose.h"
#include "import/urdf/names.h"
#include "import/urdf/topology.h"
#include "model/description.h"

namespace robcogen::import::from_urdf {

// Reports joints that the model does not have: floating joints, except one below a massless root (a note), and joints
// that mimic a joint that cannot move. With `free_mimic_joints`, one note lists all joints that mimic others.
void check_joints(const Document& document, const Topology& topology, bool free_mimic_joints, Diagnostics& diagnostics);

// The pose of a link's URDF frame in the model frame of the link that carries it.
struct Carried {
  int body = -1;  // link index; -1 for a root that is left out
  Pose pose;
};

// Returns the poses by link of the document.
std::vector<Carried> carry(const Document& document, const Topology& topology);

// `limits` are by joint of the document. Joints that mimic others are coupled unless `free_mimic_joints` is set.
model::Description describe(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const std::vector<model::JointLimits>& limits,
    bool floating_base,
    bool free_mimic_joints);

// Adds loops, couplings and independent joints. The frames of a loop are user frames `<loop>_predecessor` and
// `<loop>_successor`, whose z axes are along the axis of the loop. If any joints have `independent="false"`, these
// follow, and all other joints of a loop or a coupling are independent. Reports links that do not exist, unsupported
// types of loops, and couplings that do not determine how a joint follows.
void add_loops(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
