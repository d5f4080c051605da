// What the classes of dynamics of the first RobCoGen share: they refer to the inertia properties and to the transforms,
// whose state is that of the overloads without q.
#pragma once

#include "robcogen/compatibility/data_map.h"
#include "robcogen/compatibility/iit.h"
#include "robcogen/compatibility/parameters.h"

namespace robcogen::compatibility {

// Where a kernel writes a result of the program. Kernels must not write to what they read, so a result that is also an
// argument is written at the end.
template <class Vector>
class Result {
 public:
  template <class... Arguments>
  explicit Result(Vector& result, const Arguments&... arguments)
      : result_(result), is_argument_((... || (result.data() == arguments.data()))) {}
  ~Result() {
    if (is_argument_) result_ = copy_;
  }
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;
  auto* data() { return is_argument_ ? copy_.data() : result_.data(); }

 private:
  Vector& result_;
  const bool is_argument_;
  Vector copy_;
};

template <class Trait, class Robot, class Inertias, class Transforms>
class DynamicsBase {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using Scalar = typename Trait::Scalar;
  using CoreS = iit::rbd::Core<Scalar>;
  using Force = typename CoreS::ForceVector;
  using Velocity = typename CoreS::VelocityVector;
  using Acceleration = typename CoreS::VelocityVector;
  using JointState = compatibility::JointState<Robot, Scalar>;
  using ExtForces = DataMap<Force, typename Robot::Links>;
  using IProperties = Inertias;
  using MTransforms = Transforms;

  DynamicsBase(Inertias& inertias, Transforms& transforms) : inertias_(&inertias), transforms_(&transforms) {}

  // Updates the transforms between links, and makes q the state of functions that take none.
  void setJointStatus(const JointState& q) const { transforms_->update_links(q); }

 protected:
  // Gravity of a robot with a fixed base: along -z of the base. Kernels without an argument have the folded value.
  static constexpr double kFoldedGravity = 9.81;
  struct FixedBaseGravity {
    Scalar values[3] = {Scalar(0), Scalar(0), Scalar(-iit::rbd::g)};
    const Scalar* data() const { return values; }
  };

  const auto& parameters() const { return parameters_.of(transforms_->parameters(), inertias_->parameters()); }
  const JointState& state() const { return transforms_->state(); }
  void set_state(const JointState& q) const { transforms_->set_state(q); }

  // The wrenches on the links as kernels take them.
  static const Scalar* data(const ExtForces& fext) {
    static_assert(sizeof(ExtForces) == sizeof(Scalar) * 6 * Robot::kLinks, "wrenches are contiguous");
    return fext.begin()->data();
  }
  // The linear part of gravity, which the first RobCoGen takes as a spatial acceleration.
  static const Scalar* linear(const Acceleration& g) { return g.data() + 3; }

  template <class Kernel, class... Arrays>
  void run(Kernel kernel, Arrays... arrays) const {
    call<Robot>(kernel, parameters(), arrays...);
  }

  Inertias* inertias_;
  Transforms* transforms_;
  CombinedParameters<Robot, Scalar> parameters_;
};

}  // namespace robcogen::compatibility
