// Congruent limbs whose numbers fold in the same way.
//
// A centre of mass may be on the axis in one leg, a millimetre beside it in the others: zeros and ones of single limbs
// fold while a program is traced, and limbs that could share the lanes of vectors compute by programs of different
// shape. Where the numbers that the recursions see carry a representative number of their class (symbolic::Constant),
// only those zeros and ones fold that all its limbs have.
#pragma once

#include <array>
#include <vector>

#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {

// A plane rotation that the pose of some limb has: by a constant angle, or not (then nothing is representative). In
// limbs without it, it turns by nothing.
struct RepresentativePlane {
  int axis = 2;
  bool is_constant = false;
  bool is_missing = false;
  double c = 1.0, s = 0.0;
};

// The representative numbers of a pose and of mass properties in the limbs of a class, with the signs of this limb.
struct RepresentativeLink {
  std::array<double, 4> pose;               // offset, slide
  std::vector<RepresentativePlane> planes;  // of the rotation; empty: as they are
  std::array<double, 13> mass;              // mass, first moment, pseudo-inertia
};

// By joint: of its child. Empty: no limb differs from others of its class in what folds.
using RepresentativeLinks = std::vector<RepresentativeLink>;

// Of congruent limbs that can share lanes; their poses and masses, by joint, are constants.
RepresentativeLinks representative_links(
    const model::KinematicTree& tree,
    const std::vector<Pose>& poses,
    const std::vector<MassProperties>& masses);

// Makes the numbers fold as the representative ones do.
void fold_like(Trace& trace, const RepresentativeLink& representative, Pose& pose);
void fold_like(Trace& trace, const RepresentativeLink& representative, MassProperties& mass);

}  // namespace robcogen::algorithm
