// Spatial vectors (Featherstone 2008, ch. 2): motions and forces are different types, because they change coordinates
// by different rules.
#pragma once

#include "algorithm/spatial/vectors.h"

namespace robcogen::algorithm {

// A motion about a point: angular and linear velocity, or a change of them.
struct Motion {
  Vector3 angular;
  Vector3 linear;
};

// A force about a point, or a momentum: moment and linear force.
struct Force {
  Vector3 moment;
  Vector3 linear;
};

Motion& operator+=(Motion& a, const Motion& b);
Motion operator*(const Expression& k, const Motion& a);
Force& operator+=(Force& a, const Force& b);
Force operator+(const Force& a, const Force& b);
Force& operator-=(Force& a, const Force& b);
Force operator*(const Expression& k, const Force& a);

// The power of a force along a motion.
Expression dot(const Force& a, const Motion& b);

// S x* F: the change of a force that moves by S (Featherstone 2008, eq. 2.32).
Force cross(const Motion& S, const Force& F);

}  // namespace robcogen::algorithm
