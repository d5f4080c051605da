// Representative numbers of congruent limbs, with which constants fold in the same way in all limbs.
//
// A centre of mass may be on the axis in one leg and a millimetre off the axis in the others. A zero or one folds while
// a program is traced. If it is one in a single limb only, the program of this limb has other statements than those of
// the other limbs, and the limbs cannot be computed in the lanes of vectors. So the constants of the recursions carry a
// representative number for all limbs of a class (symbolic::Constant), which decides what folds: only zeros and ones
// that all limbs of the class have.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "algorithm/formulation/euler_rotation.h"
#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {

// A plane rotation that the pose of some limb has, by a constant angle or not (then it has no representative numbers).
// In limbs that lack it, it is the identity.
struct RepresentativePlane {
  int axis = 2;
  bool is_constant = false;
  bool is_missing = false;
  double c = 1.0, s = 0.0;
};

// The representative numbers of a pose and of mass properties in the limbs of a class, with the signs of this limb.
struct RepresentativeLink {
  std::array<double, 4> pose;               // offset, slide
  std::vector<RepresentativePlane> planes;  // of the rotation; empty: kept as they are
  std::optional<EulerRotation> euler;  // the form that the rotation takes, if planes of the limbs do not correspond
  std::array<double, 13> mass;         // mass, first moment, pseudo-inertia
};

// By joint, for its child. Empty if no limb folds differently from others of its class.
using RepresentativeLinks = std::vector<RepresentativeLink>;

// The representative numbers of congruent limbs that can share lanes. `poses` are by joint, `masses` by link; those of
// the limbs are constants.
RepresentativeLinks representative_links(
    const model::KinematicTree& tree,
    const std::vector<Pose>& poses,
    const std::vector<MassProperties>& masses);

// Makes the numbers fold as the representative ones do.
void fold_like(Trace& trace, const RepresentativeLink& representative, Pose& pose);
void fold_like(Trace& trace, const RepresentativeLink& representative, MassProperties& mass);

}  // namespace robcogen::algorithm
