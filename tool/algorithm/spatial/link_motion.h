// The motion of a link and the wrench that it takes, in 3-vectors.
//
// With U = [wd]x + [w]x [w]x, the classical acceleration of a point r of the link is a + U r, so that force and moment
// about the origin are
//     f = U h + m a,     n = (axial vector of U S) + h x a,
// with the mass properties (m, h, S). Accelerations carry gravity: the base accelerates by -g. (Featherstone 2008, ch.
// 5, in the notation of ch. 2 split into 3-vectors.)
#pragma once

#include <string_view>
#include <vector>

#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {

struct AngularState {
  Vector3 w;   // angular velocity
  Vector3 wd;  // angular acceleration
  // The link to which elements of U and products of w belong, if their quantities are given; refers to its name.
  std::string_view link = {};

  // An element of U, created on demand so that the costs of different forms of the moment can be compared.
  Expression u(std::size_t row, std::size_t column) const;
};

// U v; elements of U that meet a zero of v are not created.
Vector3 multiply_u(const AngularState& state, const Vector3& v);

// Motion of one link: everything in link axes; `a` is the classical acceleration of the origin minus gravity.
struct LinkMotion {
  AngularState angular;
  Vector3 a;
};

// The motion of a base with this twist and spatial acceleration; gravity is part of the result.
LinkMotion base_motion(const Motion& velocity, const Motion& acceleration, const Vector3& gravity);

// The motion of a rotor relative to the link that carries it: its momentum is `momentum` times `rate`, in link axes,
// and takes the moment momentum * acceleration + w x (momentum * rate).
struct RotorMotion {
  Vector3 momentum;
  Expression rate;
  Expression acceleration;
};

// The wrench about the link's origin that gives the link this motion, including the moment that its rotors take. Of
// equivalent forms of the moment, the one that adds the fewest operations to the existing ones is used. With
// `only_z_moment` only that component is computed.
Force link_wrench(
    Trace& trace,
    const MassProperties& m,
    const LinkMotion& motion,
    const std::vector<RotorMotion>& rotors = {},
    bool only_z_moment = false);

}  // namespace robcogen::algorithm
