// Mass properties of links, and of bodies that consist of several links.
#pragma once

#include "import/pose.h"
#include "import/urdf/document.h"
#include "import/urdf/topology.h"

namespace robcogen::import::from_urdf {

// Reports negative masses, and tensors that are not positive semi-definite beyond rounding: as errors, or as warnings
// for a link of a fixed base. `topology` is null when it has errors.
void check_inertials(const Document& document, const Topology* topology, bool floating_base, Diagnostics& diagnostics);

struct PlacedInertial {
  const Inertial* inertial = nullptr;
  Pose link;  // of the frame of its link in the frame of the body
};

Pose pose_of(const Origin& origin);

// About the origin and in the axes of the body's frame; nullopt for no parts.
std::optional<model::Inertia> lumped(const std::vector<PlacedInertial>& parts);

}  // namespace robcogen::import::from_urdf
