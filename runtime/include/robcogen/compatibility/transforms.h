// Coordinate transforms and Jacobians of the first RobCoGen: matrices that are updated for a state and keep their
// value.
#pragma once

#include <type_traits>

#include "robcogen/compatibility/iit.h"
#include "robcogen/compatibility/parameters.h"

namespace robcogen::compatibility {

// A pair of frames that is not that of a link and its parent.
struct FramePair {
  static constexpr int kJoint = -1;
  static constexpr bool kIsConstant = false;
};

// A pair of frames of one link.
struct ConstantPair : FramePair {
  static constexpr bool kIsConstant = true;
};

// The pairs of a link and its parent, whose joint is between them.
template <int kIndex>
struct ChildToParent {
  static constexpr int kJoint = kIndex;
  static constexpr bool kIsConstant = false, kIsChildToParent = true;
};

template <int kIndex>
struct ParentToChild {
  static constexpr int kJoint = kIndex;
  static constexpr bool kIsConstant = false, kIsChildToParent = false;
};

// The kinds of matrices: their base class, and the kernel of a pair of frames.
struct HomogeneousKind {
  template <class State, class Pair, class Self>
  using Base = iit::rbd::HomogeneousTransformBase<State, Self>;
  template <class Pair, class Scalar>
  static constexpr auto kernel = Pair::template homogeneous<Scalar>;
  static constexpr bool kIsChildToParent = true;  // of the transforms whose joint positions are the object's state
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

// Whether a transform of this kind, when it is updated, changes the state of the object that has it.
template <class Kind, class Pair>
constexpr bool has_state() {
  if constexpr (Pair::kJoint >= 0)
    return Pair::kIsChildToParent == Kind::kIsChildToParent;
  else
    return false;
}

// Where a transform writes the position of its joint, in the object that has it. A copy of a transform writes nowhere,
// and assignment keeps the place.
template <class Scalar>
class StatePlace {
 public:
  StatePlace(Scalar* place) : place_(place) {}
  StatePlace(const StatePlace&) {}
  StatePlace& operator=(const StatePlace&) { return *this; }
  void set(const Scalar& position) {
    if (place_) *place_ = position;
  }

 private:
  Scalar* place_ = nullptr;
};

template <class Kind, class Trait, class Robot, class Pair, bool kHasParameters = Robot::kHasParameters>
class StateMatrix;

// The base of a matrix of this kind. `Self` is the matrix.
template <class Kind, class Trait, class Robot, class Pair, class Self>
class StateMatrixBase : public Kind::template Base<JointState<Robot, typename Trait::Scalar>, Pair, Self> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using Scalar = typename Trait::Scalar;
  using Frames = Pair;
  using State = JointState<Robot, Scalar>;
  using Base = typename Kind::template Base<State, Pair, Self>;
  using Base::operator=;
  explicit StateMatrixBase(Scalar* place) : place_(place) {}

  const Self& update(const State& q) {
    Self& self = static_cast<Self&>(*this);
    compute(self.parameters(), q, this->data());
    if constexpr (has_state<Kind, Pair>()) place_.set(q(Pair::kJoint));
    return self;
  }

  template <class Parameters>
  static void compute(const Parameters& parameters, const State& q, Scalar* matrix) {
    call<Robot>(Kind::template kernel<Pair, Scalar>, parameters, q.data(), matrix);
  }

 protected:
  void start() {
    if constexpr (Pair::kIsConstant)
      update(State::Constant(Scalar(0)));
    else
      this->setConstant(Scalar(0));
  }

 private:
  StatePlace<Scalar> place_;
};

// A matrix of a robot without parameters. A constant transform has its value from the start; other matrices are zero
// until they are updated, because programs construct objects, or single matrices, for each call.
template <class Kind, class Trait, class Robot, class Pair>
class StateMatrix<Kind, Trait, Robot, Pair, false>
    : public StateMatrixBase<Kind, Trait, Robot, Pair, StateMatrix<Kind, Trait, Robot, Pair, false>> {
 public:
  using Base = StateMatrixBase<Kind, Trait, Robot, Pair, StateMatrix>;
  using Base::operator=;
  explicit StateMatrix(NoParameters = {}, typename Base::Scalar* place = nullptr) : Base(place) { this->start(); }
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
  explicit StateMatrix(const Owned& parameters, typename Base::Scalar* place = nullptr)
      : Base(place), parameters_(parameters) {
    this->start();
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

// The base of an object of transforms of one kind, with the state of the transforms between links and their parents.
template <class Self, class Kind, class Trait, class Robot>
class TransformsBase : public MatricesBase<Trait, Robot> {
 public:
  using Scalar = typename Trait::Scalar;
  using JState = JointState<Robot, Scalar>;
  using MatricesBase<Trait, Robot>::MatricesBase;

  const JState& state() const { return q_; }
  // Makes it the state, without computing matrices.
  void set_state(const JState& q) { q_ = q; }
  // The same, and computes these matrices.
  void update_links(const JState& q) {
    Self::visit(static_cast<Self&>(*this), [&](auto& transform) {
      using Pair = typename std::decay_t<decltype(transform)>::Frames;
      if constexpr (has_state<Kind, Pair>()) transform.update(q);
    });
  }

 protected:
  // Where a transform writes its part of the state.
  template <class Pair>
  Scalar* place() {
    if constexpr (has_state<Kind, Pair>())
      return &q_(Pair::kJoint);
    else
      return nullptr;
  }

 private:
  JState q_ = JState::Constant(Scalar(0));
};

}  // namespace robcogen::compatibility
