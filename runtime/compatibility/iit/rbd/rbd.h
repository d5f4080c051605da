// The types and functions that programs for the first RobCoGen use of <iit/rbd/rbd.h>: vectors and matrices of rigid
// bodies. 6D vectors have their angular part first.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <Eigen/StdVector>

#include <cmath>

namespace iit::rbd {

template <class Derived>
using MatrixBase = Eigen::MatrixBase<Derived>;
template <class Scalar, int kRows, int kColumns>
using PlainMatrix = Eigen::Matrix<Scalar, kRows, kColumns>;
template <class Matrix, int kRows, int kColumns>
using MatrixBlock = Eigen::Block<Matrix, kRows, kColumns>;
template <class Scalar>
using SparseMatrix = Eigen::SparseMatrix<Scalar>;
template <class Scalar>
using SparseVector = Eigen::SparseVector<Scalar>;

template <class SCALAR>
struct Core {
  using Scalar = SCALAR;
  using Matrix33 = PlainMatrix<Scalar, 3, 3>;
  using Matrix66 = PlainMatrix<Scalar, 6, 6>;
  using Vector3 = PlainMatrix<Scalar, 3, 1>;
  using Vector6 = PlainMatrix<Scalar, 6, 1>;
  using Vector6D = Vector6;
  using Column6D = Vector6;
  using VelocityVector = Vector6;
  using ForceVector = Vector6;
  using Part3D = MatrixBlock<Vector6, 3, 1>;
  using Part3DConst = MatrixBlock<const Vector6, 3, 1>;

  static Part3D angularPart(Vector6& v) { return v.template topRows<3>(); }
  static Part3D linearPart(Vector6& v) { return v.template bottomRows<3>(); }
  static Part3DConst angularPart(const Vector6& v) { return v.template topRows<3>(); }
  static Part3DConst linearPart(const Vector6& v) { return v.template bottomRows<3>(); }
};

using Cored = Core<double>;
using Matrix33d = Cored::Matrix33;
using Matrix66d = Cored::Matrix66;
using Vector3d = Cored::Vector3;
using Vector6d = Cored::Vector6;
using Vector6D = Cored::Vector6D;
using Column6d = Cored::Column6D;
using VelocityVector = Cored::VelocityVector;
using ForceVector = Cored::ForceVector;
using Part3D = Cored::Part3D;
using Part3DConst = Cored::Part3DConst;
using SparseMatrixd = SparseMatrix<double>;
using SparseColumnd = SparseVector<double>;

inline Part3D angularPart(Vector6D& v) {
  return Cored::angularPart(v);
}
inline Part3D linearPart(Vector6D& v) {
  return Cored::linearPart(v);
}
inline Part3DConst angularPart(const Vector6D& v) {
  return Cored::angularPart(v);
}
inline Part3DConst linearPart(const Vector6D& v) {
  return Cored::linearPart(v);
}

enum Coords3D { X = 0, Y, Z };
// Angular and linear coordinates of 6D vectors.
enum Coords6D { AX = 0, AY, AZ, LX, LY, LZ };

// The magnitude of gravity, m/s^2.
static const double g = 9.81;

}  // namespace iit::rbd
