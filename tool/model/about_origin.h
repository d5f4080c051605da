// Mass properties in the form of documents.
#pragma once

#include <cstddef>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// The properties about the origin and in the axes of the link frame. The centre of mass of a body without mass is the
// origin.
inline Inertia about_origin(const RigidBodyInertia& body) {
  Inertia inertia = {body.mass, {}, body.ixx, body.iyy, body.izz, body.ixy, body.ixz, body.iyz, {}};
  if (!body.mass.is_zero())
    for (std::size_t k = 0; k < 3; ++k) inertia.com[k] = body.first_moment[k] / body.mass;
  return inertia;
}

}  // namespace robcogen::model
