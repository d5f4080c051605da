// Mass properties in the form that the recursions compute with: mass m, first moment h = integral of r dm and
// pseudo-inertia S = integral of r r' dm, about the link's origin in link axes (Atkeson, An, Hollerbach 1986). The
// inertia tensor is tr(S) 1 - S.
#pragma once

#include "algorithm/spatial/pose.h"

namespace robcogen::algorithm {

struct MassProperties {
  Expression mass;
  Vector3 first_moment;
  Matrix3 pseudo_inertia;  // symmetric
};

MassProperties mass_properties(Trace& trace, const model::Link& link);

// tr(S) 1 - S.
Matrix3 inertia_tensor(const MassProperties& m);

MassProperties operator+(const MassProperties& a, const MassProperties& b);
// The properties of a child, about the parent's origin in parent axes.
MassProperties to_parent(const Pose& pose, const MassProperties& child);

}  // namespace robcogen::algorithm
