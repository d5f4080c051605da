// The subject of checks: evaluates the functions of a robot, compiled or interpreted, with fixed or floating base.
//
// The checks are templates over any type with the members of CompiledRobot (compiled_robot.h): vectors have run-time
// size, and the six coordinates of a floating base come first. Self-checks instantiate them once, for AnySubject.
#pragma once

#include <vector>

#include "robcogen/reference/dynamics.h"

namespace robcogen::reference {

// The optional arguments of a function; those that are null are left out of the call.
struct Arguments {
  const Vector<double>* gravity = nullptr;
  const std::vector<Vector<double>>* external = nullptr;
};

// The three forms of a coordinate transform.
struct TransformForms {
  Matrix<double> homogeneous = Matrix<double>(4, 4);
  Matrix<double> motion = Matrix<double>(6, 6);
  Matrix<double> force = Matrix<double>(6, 6);
};

// A result of the dynamics, and its partial derivatives: a column for each variable, the rows of the result.
struct Derivatives {
  Vector<double> value;
  Matrix<double> q, qd, last;  // by joint; the last are qdd, or tau of forward dynamics
  Matrix<double> base_rotation, base_velocity,
      base_acceleration;  // of a floating base, as far as the function has them
};

// The factor L of H for one q, and H^-1 x for one x.
struct FactorResults {
  Matrix<double> L;
  Matrix<double> inverse_L;
  Matrix<double> inverse;   // of H
  Vector<double> solution;  // H^-1 x
};

// The generalised momentum, and its rate without generalised forces.
struct MomentumAndRate {
  Vector<double> p, rate;
};

// Joint forces along a path q(s): a dds/dt^2 + b (ds/dt)^2 + c.
struct PathTerms {
  Vector<double> a, b, c;
};

inline TransformForms operator*(const TransformForms& a, const TransformForms& b) {
  return {a.homogeneous * b.homogeneous, a.motion * b.motion, a.force * b.force};
}

// (base, joints) for a floating base, otherwise only the joints.
template <class Scalar>
Vector<Scalar> coordinates(bool floating, const Vector<Scalar>& base, const Vector<Scalar>& joints) {
  return floating ? stacked(base, joints) : joints;
}

}  // namespace robcogen::reference
