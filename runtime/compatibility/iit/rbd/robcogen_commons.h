// Functions of spatial vectors that programs for the first RobCoGen may use.
#pragma once

#include <iit/rbd/InertiaMatrix.h>
#include <iit/rbd/TransformsBase.h>
#include <iit/rbd/types.h>
#include <iit/rbd/utils.h>

namespace iit::rbd {

// The matrix of the cross product v x m for motion vectors m.
template <class Scalar = double>
void motionCrossProductMx(const Velocity<Scalar>& v, Mat66<Scalar>& matrix) {
  const Vec3<Scalar> angular = v.template head<3>(), linear = v.template tail<3>();
  Utils::fillAsCrossProductMatrix(angular, matrix.template topLeftCorner<3, 3>());
  Utils::fillAsCrossProductMatrix(angular, matrix.template bottomRightCorner<3, 3>());
  Utils::fillAsCrossProductMatrix(linear, matrix.template bottomLeftCorner<3, 3>());
  matrix.template topRightCorner<3, 3>().setConstant(Scalar(0));
}

// The same for force vectors.
template <class Scalar = double>
void forceCrossProductMx(const Velocity<Scalar>& v, Mat66<Scalar>& matrix) {
  Mat66<Scalar> of_motions;
  motionCrossProductMx<Scalar>(v, of_motions);
  matrix = -of_motions.transpose();
}

// The force v x* I v that keeps the velocity of a body.
template <class Derived>
Force<typename Derived::Scalar> vxIv(const Velocity<typename Derived::Scalar>& v, const MatrixBase<Derived>& inertia) {
  Mat66<typename Derived::Scalar> cross;
  forceCrossProductMx<typename Derived::Scalar>(v, cross);
  return cross * (inertia * v);
}

// The inertia in the axes and about the origin of B, from that of A and the force transform B_X_A.
template <class Scalar = double>
void transformInertia(const InertiaMat<Scalar>& in_A, const Mat66<Scalar>& B_X_A, InertiaMat<Scalar>& in_B) {
  in_B = B_X_A * in_A * B_X_A.transpose();
}

}  // namespace iit::rbd
