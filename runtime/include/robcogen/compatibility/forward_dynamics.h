// ForwardDynamics of the first RobCoGen over the kernels. The overloads without q are those of the last state.
#pragma once

#include "robcogen/compatibility/dynamics.h"

namespace robcogen::compatibility {

template <class Trait, class Robot, class Inertias, class Transforms, bool kFloatingBase = Robot::kFloatingBase>
class ForwardDynamics;

template <class Trait, class Robot, class Inertias, class Transforms>
class ForwardDynamics<Trait, Robot, Inertias, Transforms, false>
    : public DynamicsBase<Trait, Robot, Inertias, Transforms> {
 public:
  using Base = DynamicsBase<Trait, Robot, Inertias, Transforms>;
  using Base::Base;
  using typename Base::ExtForces;
  using typename Base::JointState;
  using typename Base::Scalar;

  void fd(JointState& qdd, const JointState& q, const JointState& qd, const JointState& tau) {
    this->set_state(q);
    compute(qdd, q, qd, tau, nullptr);
  }
  void fd(JointState& qdd, const JointState& q, const JointState& qd, const JointState& tau, const ExtForces& fext) {
    this->set_state(q);
    compute(qdd, q, qd, tau, this->data(fext));
  }
  void fd(JointState& qdd, const JointState& qd, const JointState& tau) {
    compute(qdd, this->state(), qd, tau, nullptr);
  }
  void fd(JointState& qdd, const JointState& qd, const JointState& tau, const ExtForces& fext) {
    compute(qdd, this->state(), qd, tau, this->data(fext));
  }

 private:
  void compute(
      JointState& qdd,
      const JointState& q,
      const JointState& qd,
      const JointState& tau,
      const Scalar* external) const {
    Result result(qdd, q, qd, tau);
    const typename Base::FixedBaseGravity gravity;
    if (external)
      this->run(
          Robot::template forward_dynamics_external<Scalar>, q.data(), qd.data(), tau.data(), gravity.data(), external,
          result.data());
    else if (iit::rbd::g == Base::kFoldedGravity)
      this->run(Robot::template forward_dynamics<Scalar>, q.data(), qd.data(), tau.data(), result.data());
    else
      this->run(
          Robot::template forward_dynamics_gravity<Scalar>, q.data(), qd.data(), tau.data(), gravity.data(),
          result.data());
  }
};

template <class Trait, class Robot, class Inertias, class Transforms>
class ForwardDynamics<Trait, Robot, Inertias, Transforms, true>
    : public DynamicsBase<Trait, Robot, Inertias, Transforms> {
 public:
  using Base = DynamicsBase<Trait, Robot, Inertias, Transforms>;
  using Base::Base;
  using typename Base::Acceleration;
  using typename Base::ExtForces;
  using typename Base::JointState;
  using typename Base::Scalar;
  using typename Base::Velocity;

  void fd(
      JointState& qdd,
      Acceleration& base_a,
      const Velocity& base_v,
      const Acceleration& g,
      const JointState& q,
      const JointState& qd,
      const JointState& tau) {
    this->set_state(q);
    compute(qdd, base_a, base_v, g, q, qd, tau, nullptr);
  }
  void fd(
      JointState& qdd,
      Acceleration& base_a,
      const Velocity& base_v,
      const Acceleration& g,
      const JointState& q,
      const JointState& qd,
      const JointState& tau,
      const ExtForces& fext) {
    this->set_state(q);
    compute(qdd, base_a, base_v, g, q, qd, tau, this->data(fext));
  }
  void fd(
      JointState& qdd,
      Acceleration& base_a,
      const Velocity& base_v,
      const Acceleration& g,
      const JointState& qd,
      const JointState& tau) {
    compute(qdd, base_a, base_v, g, this->state(), qd, tau, nullptr);
  }
  void fd(
      JointState& qdd,
      Acceleration& base_a,
      const Velocity& base_v,
      const Acceleration& g,
      const JointState& qd,
      const JointState& tau,
      const ExtForces& fext) {
    compute(qdd, base_a, base_v, g, this->state(), qd, tau, this->data(fext));
  }

 private:
  void compute(
      JointState& qdd,
      Acceleration& base_a,
      const Velocity& base_v,
      const Acceleration& g,
      const JointState& q,
      const JointState& qd,
      const JointState& tau,
      const Scalar* external) const {
    Result joints(qdd, q, qd, tau);
    Result base(base_a, base_v, g);
    if (external)
      this->run(
          Robot::template forward_dynamics_external<Scalar>, q.data(), qd.data(), tau.data(), base_v.data(),
          this->linear(g), external, joints.data(), base.data());
    else
      this->run(
          Robot::template forward_dynamics<Scalar>, q.data(), qd.data(), tau.data(), base_v.data(), this->linear(g),
          joints.data(), base.data());
  }
};

}  // namespace robcogen::compatibility
