// Results of functions of floating-base robots; kDof joints.
#pragma once

#include "robcogen/matrix.h"
#include "robcogen/spatial.h"

namespace robcogen {

// Joint forces (N m, N), and the spatial acceleration of a base without a wrench on it (base coordinates, gravity not
// included).
template <class Scalar, int kDof>
struct ROBCOGEN_ALIGNED InverseDynamics {
  Matrix<Scalar, kDof, 1> tau;
  BasicSpatialAcceleration<Scalar> base_acceleration;
};

// Joint forces (N m, N), and the wrench on the base (base coordinates, about the base origin).
template <class Scalar, int kDof>
struct ROBCOGEN_ALIGNED GeneralizedForce {
  Matrix<Scalar, kDof, 1> tau;
  BasicWrench<Scalar> base_wrench;
};

// Joint accelerations (rad/s^2, m/s^2), and the spatial acceleration of the base (base coordinates, gravity not
// included).
template <class Scalar, int kDof>
struct ROBCOGEN_ALIGNED GeneralizedAcceleration {
  Matrix<Scalar, kDof, 1> qdd;
  BasicSpatialAcceleration<Scalar> base_acceleration;
};

}  // namespace robcogen
