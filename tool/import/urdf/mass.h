// Mass properties of links, and of several links in one body.
#pragma once

#include "import/urdf/document.h"
#include "import/urdf/pose.h"
#include "import/urdf/topology.h"

namespace robcogen::import::from_urdf {

// Reports masses that are negative, and tensors that are not positive semi-definite but for rounding: as errors, or as
// warnings where the link is part of a base that does not move. `topology` may be null, where it was wrong.
void check_inertials(const Document& document, const Topology* topology, bool floating_base, Diagnostics& diagnostics);

struct PlacedInertial {
  const Inertial* inertial = nullptr;
  Pose link;  // of its link's frame in the body's
};

Pose pose_of(const Origin& origin);

// About the origin and in the axes of the body's frame; nullopt for no parts.
std::optional<model::Inertia> lumped(const std::vector<PlacedInertial>& parts);

}  // namespace robcogen::import::from_urdf
