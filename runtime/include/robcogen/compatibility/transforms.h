// Coordinate transforms and Jacobians of the first RobCoGen: matrices that are updated for a state and keep their
// value.
#pragma once

#include "robcogen/compatibility/iit.h"
#include "robcogen/compatibility/parameters.h"

namespace robcogen::compatibility {

// A pair of frames that is not that of a link and its parent.
struct FramePair {
  static constexpr int kJoint = -1;
};

// The pair of a link and its parent; the joint is between them.
template <int kIndex>
struct LinkPair {
  static constexpr int kJoint = kIndex;
};

// The kinds of matrices: their base class, and the kernel of a pair of frames.
struct HomogeneousKind {
  template <class State, class Pair, class Self>
  using Base = iit::rbd::HomogeneousTransformBase<State, Self>;
  template <class Pair, class Scalar>
  static constexpr auto kernel = Pair::template homogeneous<Scalar>;
  static constexpr bool kIsChildToParent = true;  // the transform whose position the container has
};

struct MotionKind {
  template <class State, class Pair, class Self>
  using Base = iit::rbd::SpatialTransformBase<State, Self>;
  template <class Pair, class Scalar>
  static constexpr auto kernel = Pair::template motion<Scalar>;
  static constexpr bool kIsChildToParent = false;
};

struct ForceKind {
  template <class State, class Pair, class Self>
  using Base = iit::rbd::SpatialTransformBase<State, Self>;
  template <class Pair, class Scalar>
  static constexpr auto kernel = Pair::template force<Scalar>;
  static constexpr bool kIsChildToParent = true;
};

struct JacobianKind {
  template <class State, class Pair, class Self>
  using Base = iit::rbd::JacobianBase<State, Pair::kColumns, Self>;
  template <class Pair, class Scalar>
  static constexpr auto kernel = Pair::template jacobian<Scalar>;
};

// Holds the position of the joint of a LinkPair, so that functions of an object's current state see it.
template <class Scalar, bool kIsKept>
struct KeptPosition {
  template <class State>
  void keep(const State&, int) {}
};

template <class Scalar>
struct KeptPosition<Scalar, true> {
  Scalar position = Scalar(0);
  template <class State>
  void keep(const State& q, int joint) {
    position = q(joint);
  }
};

template <class Kind, class Trait, class Robot, class Pair, bool kHasParameters = Robot::kHasParameters>
class StateMatrix;

// The base of a matrix of this kind. `Self` is the matrix.
template <class Kind, class Trait, class Robot, class Pair, class Self>
class StateMatrixBase : public Kind::template Base<JointState<Robot, typename Trait::Scalar>, Pair, Self>,
                        public KeptPosition<typename Trait::Scalar, Pair::kJoint >= 0> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using Scalar = typename Trait::Scalar;
  using State = JointState<Robot, Scalar>;
  using Base = typename Kind::template Base<State, Pair, Self>;
  using Base::operator=;

  const Self& update(const State& q) {
    Self& self = static_cast<Self&>(*this);
    compute(self.parameters(), q, this->data());
    this->keep(q, Pair::kJoint);
    return self;
  }

  template <class Parameters>
  static void compute(const Parameters& parameters, const State& q, Scalar* matrix) {
    call<Robot>(Kind::template kernel<Pair, Scalar>, parameters, q.data(), matrix);
  }
};

// A matrix of a robot without parameters. Until it is updated, it has its value where all joints are at zero; that of a
// constant transform never changes.
template <class Kind, class Trait, class Robot, class Pair>
class StateMatrix<Kind, Trait, Robot, Pair, false>
    : public StateMatrixBase<Kind, Trait, Robot, Pair, StateMatrix<Kind, Trait, Robot, Pair, false>> {
 public:
  using Base = StateMatrixBase<Kind, Trait, Robot, Pair, StateMatrix>;
  using Base::operator=;
  explicit StateMatrix(NoParameters = {}) { this->update(Base::State::Constant(typename Base::Scalar(0))); }
  NoParameters parameters() const { return {}; }
};

// A matrix of a robot with parameters, which belong to the object that has the matrix.
template <class Kind, class Trait, class Robot, class Pair>
class StateMatrix<Kind, Trait, Robot, Pair, true>
    : public StateMatrixBase<Kind, Trait, Robot, Pair, StateMatrix<Kind, Trait, Robot, Pair, true>> {
 public:
  using Base = StateMatrixBase<Kind, Trait, Robot, Pair, StateMatrix>;
  using Base::operator=;
  using Owned = ParametersOf<Robot, typename Trait::Scalar, typename Robot::KinematicsGetters>;
  using Parameters = ParameterReference<Owned>;
  explicit StateMatrix(const Owned& parameters) : parameters_(parameters) {
    this->update(Base::State::Constant(typename Base::Scalar(0)));
  }
  const Parameters& parameters() const { return parameters_; }

 private:
  Parameters parameters_;
};

// The base of an object of matrices: their kinematics parameters, which a program gives in structures or by getters.
template <class Trait, class Robot>
class MatricesBase {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using Scalar = typename Trait::Scalar;
  using CoreS = iit::rbd::Core<Scalar>;
  using JState = JointState<Robot, Scalar>;
  using Parameters = ParametersOf<Robot, Scalar, typename Robot::KinematicsGetters>;

  MatricesBase() = default;
  template <class... Getters>
  explicit MatricesBase(const Getters*... getters) : parameters_(typename Robot::KinematicsGetters(getters...)) {}

  // Version 5: new values.
  template <class Lengths, class Angles>
  void updateParams(const Lengths& lengths, const Angles& angles) {
    parameters_.set(lengths, angles);
  }
  template <class Lengths, class Angles>
  void updateParameters(const Lengths& lengths, const Angles& angles) {
    parameters_.set(lengths, angles);
  }
  // Version 0.4: reads the getters again.
  void updateParameters() { parameters_.read(); }

  const Parameters& parameters() const { return parameters_; }

 private:
  Parameters parameters_;
};

// The base of an object of transforms of one kind.
template <class Self, class Kind, class Trait, class Robot>
class TransformsBase : public MatricesBase<Trait, Robot> {
 public:
  using Scalar = typename Trait::Scalar;
  using JState = JointState<Robot, Scalar>;
  using MatricesBase<Trait, Robot>::MatricesBase;

  // The state of which the transforms between links and their parents are.
  JState state() const {
    JState q;
    visit(static_cast<const Self&>(*this), [&](int joint, const auto& transform) { q(joint) = transform.position; });
    return q;
  }
  // Makes it the state, without computing matrices.
  void set_state(const JState& q) {
    visit(static_cast<Self&>(*this), [&](int joint, auto& transform) { transform.position = q(joint); });
  }
  // The same, and computes these matrices.
  void update_links(const JState& q) {
    visit(static_cast<Self&>(*this), [&](int, auto& transform) { transform.update(q); });
  }

 private:
  template <class Object, class Visitor>
  static void visit(Object& object, const Visitor& visitor) {
    Self::visit_links(object, [&](int joint, auto& child_to_parent, auto& parent_to_child) {
      if constexpr (Kind::kIsChildToParent)
        visitor(joint, child_to_parent);
      else
        visitor(joint, parent_to_child);
    });
  }
};

}  // namespace robcogen::compatibility
