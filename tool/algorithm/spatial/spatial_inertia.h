// Articulated-body and rigid-body inertias as three 3 x 3 blocks.
#pragma once

#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {

// Relates an acceleration (wd, a) to the force (n, f) that it takes: n = A wd + B a, f = B' wd + M a, A and M
// symmetric.
struct SpatialInertia {
  Matrix3 a;
  Matrix3 b;
  Matrix3 m;
};

SpatialInertia rigid_body_inertia(const MassProperties& body);

SpatialInertia operator+(const SpatialInertia& x, const SpatialInertia& y);
// The inertia of a child, about the parent's origin in the parent's axes.
SpatialInertia to_parent(const Pose& X_PC, const SpatialInertia& child);

// [A B; B' M].
SquareMatrix matrix(const SpatialInertia& x);

}  // namespace robcogen::algorithm
