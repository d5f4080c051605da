// The spatial inertia of a rigid body, a 6 x 6 matrix.
#pragma once

#include <iit/rbd/rbd.h>

namespace iit::rbd {
namespace tpl {

template <class SCALAR>
class InertiaMatrixDense : public Core<SCALAR>::Matrix66 {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using Scalar = SCALAR;
  using Base = typename Core<Scalar>::Matrix66;
  using Mat33 = typename Core<Scalar>::Matrix33;
  using Vec3 = typename Core<Scalar>::Vector3;

  InertiaMatrixDense() { this->setConstant(Scalar(0)); }
  InertiaMatrixDense(Scalar mass, const Vec3& com, const Mat33& tensor) { fill(mass, com, tensor); }
  template <class Derived>
  InertiaMatrixDense& operator=(const MatrixBase<Derived>& other) {
    Base::operator=(other);
    return *this;
  }
  template <class Derived>
  InertiaMatrixDense& operator+=(const MatrixBase<Derived>& other) {
    Base::operator+=(other);
    return *this;
  }

  // Sets the properties; the tensor is about the origin.
  void fill(Scalar mass, const Vec3& com, const Mat33& tensor) {
    this->setConstant(Scalar(0));
    this->template topLeftCorner<3, 3>() = tensor;
    set_first_moment(Vec3(com * mass));
    for (int i = 3; i < 6; ++i) (*this)(i, i) = mass;
  }

  Scalar getMass() const { return (*this)(LX, LX); }
  Vec3 getCOM() const { return Vec3((*this)(AZ, LY), (*this)(AX, LZ), (*this)(AY, LX)) / getMass(); }
  Eigen::Block<const Base, 3, 3> get3x3Tensor() const { return Eigen::Block<const Base, 3, 3>(*this, 0, 0); }

  // Scales all properties but the centre of mass.
  void changeMass(Scalar mass) { *this *= Scalar(mass / getMass()); }
  // Moves the centre of mass, with the same tensor about it.
  void changeCOM(const Vec3& com) {
    const Mat33 before = this->template topRightCorner<3, 3>();
    set_first_moment(Vec3(com * getMass()));
    const Mat33 after = this->template topRightCorner<3, 3>();
    const Mat33 change = (after * after.transpose() - before * before.transpose()) / getMass();
    this->template topLeftCorner<3, 3>() += change;
  }
  void changeRotationalInertia(const Mat33& tensor) { this->template topLeftCorner<3, 3>() = tensor; }

 private:
  void set_first_moment(const Vec3& h) {
    const Scalar zero(0);
    this->template topRightCorner<3, 3>() << zero, -h(2), h(1), h(2), zero, -h(0), -h(1), h(0), zero;
    const Mat33 upper = this->template topRightCorner<3, 3>();
    this->template bottomLeftCorner<3, 3>() = upper.transpose();
  }
};

}  // namespace tpl

using InertiaMatrixDense = tpl::InertiaMatrixDense<double>;

}  // namespace iit::rbd
