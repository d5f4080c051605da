// JSIM of the first RobCoGen: the joint-space inertia matrix, updated for a state, with its factor and its inverse.
#pragma once

#include "robcogen/compatibility/iit.h"
#include "robcogen/compatibility/parameters.h"

namespace robcogen::compatibility {

template <class Trait, class Robot, class Inertias, class Transforms>
class Jsim : public iit::rbd::StateDependentMatrix<
                 compatibility::JointState<Robot, typename Trait::Scalar>,
                 Robot::kCoordinates,
                 Robot::kCoordinates,
                 Jsim<Trait, Robot, Inertias, Transforms>> {
  using Base = iit::rbd::StateDependentMatrix<
      compatibility::JointState<Robot, typename Trait::Scalar>,
      Robot::kCoordinates,
      Robot::kCoordinates,
      Jsim>;
  static constexpr int kJoints = Robot::kJoints;

 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using Scalar = typename Trait::Scalar;
  using JointState = compatibility::JointState<Robot, Scalar>;
  using MatrixType = iit::rbd::PlainMatrix<Scalar, Robot::kCoordinates, Robot::kCoordinates>;
  using Index = typename MatrixType::Index;
  using BlockF_t = const Eigen::Block<const MatrixType, 6, kJoints>;
  using BlockFixedBase_t = const Eigen::Block<const MatrixType, kJoints, kJoints>;
  using IProperties = Inertias;
  using FTransforms = Transforms;
  using InertiaMatrix = compatibility::InertiaMatrix<Scalar>;
  using Base::operator=;

  Jsim(Inertias& inertias, Transforms& transforms) : inertias_(&inertias), transforms_(&transforms) {
    const Scalar zero(0);
    this->setConstant(zero);
    q_.setConstant(zero);
    L_.setConstant(zero);
    inverse_.setConstant(zero);
    inverse_diagonal_.setConstant(zero);
  }

  const Jsim& update(const JointState& q) {
    q_ = q;
    call<Robot>(Robot::template joint_space_inertia<Scalar>, parameters(), q.data(), this->data());
    return *this;
  }

  // The factor L of L^T L = H in the state of the last update. Elements of H that a program has changed since then have
  // no effect.
  void computeL() {
    call<Robot>(
        Robot::template joint_space_inertia_factor<Scalar>, parameters(), q_.data(), L_.data(),
        inverse_diagonal_.data());
  }
  // The inverse of H, from L.
  void computeInverse() {
    call<Factor>(
        Robot::template inertia_factor_inverse<Scalar>, NoParameters(), L_.data(), inverse_diagonal_.data(),
        inverse_.data());
  }

  const MatrixType& getL() const { return L_; }
  const MatrixType& getInverse() const { return inverse_; }

  // Of a floating base.
  const InertiaMatrix& getWholeBodyInertia() const {
    static_assert(
        Robot::kFloatingBase,
        "a fixed base has no getWholeBodyInertia(): InertiaProperties has the inertia of each link");
    if constexpr (Robot::kFloatingBase) whole_body_ = this->template topLeftCorner<6, 6>();
    return whole_body_;
  }
  BlockF_t getF() const {
    static_assert(Robot::kFloatingBase, "a fixed base has no getF(): the JSIM has the rows of the joints only");
    return BlockF_t(*this, 0, 6);
  }
  BlockFixedBase_t getFixedBaseBlock() const {
    static_assert(Robot::kFloatingBase, "a fixed base has no getFixedBaseBlock(): it is the JSIM itself");
    return BlockFixedBase_t(*this, 6, 6);
  }

 private:
  // The functions of the factor take no parameters.
  struct Factor {
    static constexpr bool kHasParameters = false;
  };

  const auto& parameters() const { return parameters_.of(transforms_->parameters(), inertias_->parameters()); }

  Inertias* inertias_;
  Transforms* transforms_;
  CombinedParameters<Robot, Scalar> parameters_;
  JointState q_;
  MatrixType L_, inverse_;
  iit::rbd::PlainMatrix<Scalar, Robot::kCoordinates, 1> inverse_diagonal_;
  mutable InertiaMatrix whole_body_;
};

}  // namespace robcogen::compatibility
