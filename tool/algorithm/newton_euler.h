// Newton-Euler in its cheap form: 3-vectors and pseudo-inertias.
//
// A link's mass properties are (m, h, S): mass, first moment h = integral of r dm, pseudo-inertia S = integral of r r'
// dm, about the link's origin in link axes; the inertia tensor is tr(S) 1 - S. With U = [wd]x + [w]x [w]x, the
// classical acceleration of a point r of the link is a + U r, so that force and moment about the origin are
//     f = U h + m a,     n = (axial vector of U S) + h x a.
// Accelerations carry gravity: the base accelerates by -g. (Featherstone 2008, ch. 5, in the notation of ch. 2 split
// into 3-vectors; pseudo-inertia: Atkeson, An, Hollerbach 1986.)
#pragma once

#include <vector>

#include "algorithm/geometry.h"

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

struct AngularState {
  Vector3 w;   // angular velocity
  Vector3 wd;  // angular acceleration

  // An element of U. Made when it is asked for, so that the cost of a form of the moment can be told.
  Expression u(std::size_t row, std::size_t column) const;
};

// U v; elements of U that meet a zero of v are not made.
Vector3 multiply_u(const AngularState& state, const Vector3& v);

// Motion of one link: everything in link axes; `a` is the classical acceleration of the origin minus gravity.
struct LinkMotion {
  AngularState angular;
  Vector3 a;
};

// Motion of a child from its parent's, joint velocity and acceleration.
LinkMotion child_motion(
    const Pose& pose,
    bool revolute,
    const LinkMotion& parent,
    const Expression& qd,
    const Expression& qdd);

// The wrench that gives the link this motion, about its origin. Of three equivalent forms of the moment, the one that
// adds fewest operations to what is computed already. With `only_z` nothing but that moment component is wanted.
Spatial link_wrench(Trace& trace, const MassProperties& m, const LinkMotion& motion, bool only_z_moment = false);

// A wrench on the child, about the parent's origin in parent axes.
Spatial to_parent(const Pose& pose, const Spatial& wrench);

// The motion (twist, or change of it) of a body, about the child's origin in child axes; given about the parent's.
Spatial to_child(const Pose& pose, const Spatial& motion);
// Twist of the child link, from its parent's and the joint's rate.
Spatial child_twist(const Pose& pose, bool revolute, const Spatial& parent, const Expression& qd);

}  // namespace robcogen::algorithm
