// Equal limbs whose numbers fold alike.
//
// A centre of mass on the axis in one leg, a millimetre beside it in the others: zeros and ones of single limbs fold
// while a program is traced, and limbs that could share the lanes of vectors compute by programs of different shape.
// With the numbers that the recursions see marked by what is typical of the class (Number::among), only those zeros and
// ones fold that all its limbs have.
#pragma once

#include <array>
#include <vector>

#include "algorithm/newton_euler.h"

namespace robcogen::algorithm {

// What stands in the places of a pose and of mass properties in limbs of a class, with the signs of this limb.
struct TypicalLink {
  std::array<double, 4> pose;   // offset, slide
  std::array<double, 13> mass;  // mass, first moment, pseudo-inertia
};

// By joint: of its child. Empty: no limb differs from others of its class in what folds.
using TypicalLinks = std::vector<TypicalLink>;

// For equal limbs that can share lanes; their poses and masses, by joint, are constants.
TypicalLinks typical_links(
    const model::KinematicTree& tree,
    const std::vector<Pose>& poses,
    const std::vector<MassProperties>& masses);

// Marks the numbers by what is typical of their places.
void see_among(Trace& trace, const TypicalLink& typical, Pose& pose);
void see_among(Trace& trace, const TypicalLink& typical, MassProperties& mass);

}  // namespace robcogen::algorithm
