// Mass properties of links, and of bodies that consist of several links.
#pragma once

#include "import/pose.h"
#include "import/urdf/document.h"
#include "import/urdf/topology.h"

namespace robcogen::import::from_urdf {

// Reports inertials without a mass: as errors, or as warnings for a link of a fixed base, whose inertial is removed.
// `topology` is nullptr if it has errors.
void check_masses(Document& document, const Topology* topology, bool floating_base, Diagnostics& diagnostics);

// Reports negative masses, and tensors that are not positive semi-definite beyond rounding: as errors, or as warnings
// for a link of a fixed base. `topology` is nullptr if it has errors.
void check_inertials(const Document& document, const Topology* topology, bool floating_base, Diagnostics& diagnostics);

struct PlacedInertial {
  const Inertial* inertial = nullptr;
  Pose link;  // pose of its link's frame in the frame of the body
};

Pose pose_of(const Origin& origin);

// Returns the sum of the parts about the origin and in the axes of the body's frame; nullopt if there are no parts.
std::optional<model::Inertia> lumped(const std::vector<PlacedInertial>& parts);

}  // namespace robcogen::import::from_urdf
