// Functions of rotations, transforms and inertias.
#pragma once

#include <iit/rbd/rbd.h>
#include <iit/rbd/types.h>

#include <cmath>

namespace iit::rbd {

class Utils {
 public:
  struct InertiaMoments {
    double ixx, iyy, izz, ixy, ixz, iyz;
  };

  // The tensor with these moments, and products of positive sign.
  template <class Scalar>
  static Mat33<Scalar> buildInertiaTensor(Scalar ixx, Scalar iyy, Scalar izz, Scalar ixy, Scalar ixz, Scalar iyz) {
    Mat33<Scalar> tensor;
    tensor << ixx, -ixy, -ixz, -ixy, iyy, -iyz, -ixz, -iyz, izz;
    return tensor;
  }

  static Matrix33d buildCrossProductMatrix(const Vector3d& v) {
    Matrix33d matrix;
    fillAsCrossProductMatrix(v, matrix);
    return matrix;
  }
  template <class Vector, class Matrix>
  static void fillAsCrossProductMatrix(const MatrixBase<Vector>& v, const MatrixBase<Matrix>& matrix) {
    using Scalar = typename Vector::Scalar;
    const Scalar zero(0);
    const_cast<MatrixBase<Matrix>&>(matrix) << zero, -v(2), v(1), v(2), zero, -v(0), -v(1), v(0), zero;
  }

  // B_X_A, where B is turned against A about x, then the new y, then the new z.
  static Matrix33d buildRotationMatrix(double rx, double ry, double rz) {
    const Matrix33d a_X_b = (Eigen::AngleAxisd(rx, Vector3d::UnitX()) * Eigen::AngleAxisd(ry, Vector3d::UnitY()) *
                             Eigen::AngleAxisd(rz, Vector3d::UnitZ()))
                                .toRotationMatrix();
    return a_X_b.transpose();
  }
  template <class Matrix>
  static void fillAsRotationMatrix(double rx, double ry, double rz, const MatrixBase<Matrix>& matrix) {
    const_cast<MatrixBase<Matrix>&>(matrix) = buildRotationMatrix(rx, ry, rz);
  }

  // Parts of a homogeneous transform.
  template <class Matrix>
  static Eigen::Block<const Matrix, 3, 1> positionVector(const MatrixBase<Matrix>& transform) {
    return transform.template block<3, 1>(0, 3);
  }
  template <class Matrix>
  static Eigen::Block<const Matrix, 3, 3> rotationMx(const MatrixBase<Matrix>& transform) {
    return transform.template block<3, 3>(0, 0);
  }
  template <class Matrix>
  static Eigen::Block<const Matrix, 3, 1> zAxis(const MatrixBase<Matrix>& transform) {
    return transform.template block<3, 1>(0, 2);
  }
  // The point in coordinates of the left frame.
  template <class Matrix, class Vector>
  static Vec3<typename Matrix::Scalar> transform(const MatrixBase<Matrix>& transform, const MatrixBase<Vector>& point) {
    return rotationMx(transform) * point + positionVector(transform);
  }
};

}  // namespace iit::rbd
