// InverseDynamics of the first RobCoGen over the kernels. The overloads without q are those of the last state.
#pragma once

#include <algorithm>

#include "robcogen/compatibility/dynamics.h"
#include "robcogen/compatibility/link_motions.h"

namespace robcogen::compatibility {

// The motion of the last call, and the getters of the links.
template <class Trait, class Robot, class Inertias, class Transforms>
class InverseDynamicsBase : public DynamicsBase<Trait, Robot, Inertias, Transforms> {
 public:
  using Base = DynamicsBase<Trait, Robot, Inertias, Transforms>;
  using Base::Base;
  using typename Base::Acceleration;
  using typename Base::ExtForces;
  using typename Base::Force;
  using typename Base::JointState;
  using typename Base::Scalar;
  using typename Base::Velocity;

  // Of a link by its number in LinkIdentifiers, in coordinates of the link, in the motion of the last call.
  // Accelerations do not include gravity: they are relative to free fall.
  const Velocity& velocity(int link) const { return links().velocity[link]; }
  const Acceleration& acceleration(int link) const { return links().acceleration[link]; }
  const Force& force(int link) const { return links().force[link]; }

 protected:
  void set_motion(const JointState& q, const JointState& qd, const JointState& qdd, const Scalar* external) {
    motion_.q = q;
    motion_.qd = qd;
    motion_.qdd = qdd;
    motion_.has_wrenches = external != nullptr;
    if (external) std::copy_n(external, 6 * Robot::kLinks, motion_.wrenches.front().data());
    is_current_ = false;
  }
  void set_base(const Velocity& v, const Acceleration& a, const Acceleration& g) {
    motion_.base_velocity = v;
    motion_.base_acceleration = a - g;
    base_is_free_ = false;
  }
  // Nothing holds the base: its acceleration is a result.
  void set_free_base(const Velocity& v, const Acceleration& g) {
    motion_.base_velocity = v;
    gravity_ = g;
    base_is_free_ = true;
  }
  // The acceleration of a fixed base relative to free fall.
  void set_upwards(double g) { motion_.base_acceleration(5) = Scalar(g); }

 private:
  using Links = LinkMotions<Trait, Robot>;

  const Links& links() const {
    if (is_current_) return links_;
    is_current_ = true;
    typename Links::Motion motion = motion_;
    if constexpr (Robot::kFloatingBase) {
      if (base_is_free_) motion.base_acceleration = free_acceleration() - gravity_;
    }
    links_.compute(motion, *this->transforms_, *this->inertias_);
    return links_;
  }

  Acceleration free_acceleration() const {
    const typename Links::Motion& m = motion_;
    JointState tau;
    Acceleration a;
    if (m.has_wrenches)
      this->run(
          Robot::template inverse_dynamics_external<Scalar>, m.q.data(), m.qd.data(), m.qdd.data(),
          m.base_velocity.data(), this->linear(gravity_), m.wrenches[0].data(), tau.data(), a.data());
    else
      this->run(
          Robot::template inverse_dynamics<Scalar>, m.q.data(), m.qd.data(), m.qdd.data(), m.base_velocity.data(),
          this->linear(gravity_), tau.data(), a.data());
    return a;
  }

  typename Links::Motion motion_;
  Acceleration gravity_ = Acceleration::Constant(Scalar(0));  // where the base is free
  bool base_is_free_ = false;
  mutable Links links_;
  mutable bool is_current_ = false;
};

template <class Trait, class Robot, class Inertias, class Transforms, bool kFloatingBase = Robot::kFloatingBase>
class InverseDynamics;

template <class Trait, class Robot, class Inertias, class Transforms>
class InverseDynamics<Trait, Robot, Inertias, Transforms, false>
    : public InverseDynamicsBase<Trait, Robot, Inertias, Transforms> {
 public:
  using Base = InverseDynamicsBase<Trait, Robot, Inertias, Transforms>;
  using Base::Base;
  using typename Base::Acceleration;
  using typename Base::ExtForces;
  using typename Base::JointState;
  using typename Base::Scalar;

  void id(JointState& jForces, const JointState& q, const JointState& qd, const JointState& qdd) {
    this->set_state(q);
    compute(jForces, q, qd, qdd, nullptr);
  }
  void id(
      JointState& jForces,
      const JointState& q,
      const JointState& qd,
      const JointState& qdd,
      const ExtForces& fext) {
    this->set_state(q);
    compute(jForces, q, qd, qdd, this->data(fext));
  }
  void id(JointState& jForces, const JointState& qd, const JointState& qdd) {
    compute(jForces, this->state(), qd, qdd, nullptr);
  }
  void id(JointState& jForces, const JointState& qd, const JointState& qdd, const ExtForces& fext) {
    compute(jForces, this->state(), qd, qdd, this->data(fext));
  }

  void G_terms(JointState& jForces, const JointState& q) {
    this->set_state(q);
    compute_gravity(jForces, q);
  }
  void G_terms(JointState& jForces) { compute_gravity(jForces, this->state()); }

  void C_terms(JointState& jForces, const JointState& q, const JointState& qd) {
    this->set_state(q);
    compute_coriolis(jForces, q, qd);
  }
  void C_terms(JointState& jForces, const JointState& qd) { compute_coriolis(jForces, this->state(), qd); }

 private:
  void compute(
      JointState& jForces,
      const JointState& q,
      const JointState& qd,
      const JointState& qdd,
      const Scalar* external) {
    this->set_motion(q, qd, qdd, external);
    this->set_upwards(iit::rbd::g);
    Result result(jForces, q, qd, qdd);
    const typename Base::FixedBaseGravity gravity;
    if (external)
      this->run(
          Robot::template inverse_dynamics_external<Scalar>, q.data(), qd.data(), qdd.data(), gravity.data(), external,
          result.data());
    else if (iit::rbd::g == Base::kFoldedGravity)
      this->run(Robot::template inverse_dynamics<Scalar>, q.data(), qd.data(), qdd.data(), result.data());
    else
      this->run(
          Robot::template inverse_dynamics_gravity<Scalar>, q.data(), qd.data(), qdd.data(), gravity.data(),
          result.data());
  }
  void compute_gravity(JointState& jForces, const JointState& q) {
    const JointState zero = JointState::Constant(Scalar(0));
    this->set_motion(q, zero, zero, nullptr);
    this->set_upwards(iit::rbd::g);
    Result result(jForces, q);
    const typename Base::FixedBaseGravity gravity;
    if (iit::rbd::g == Base::kFoldedGravity)
      this->run(Robot::template gravity_forces<Scalar>, q.data(), result.data());
    else
      this->run(Robot::template gravity_forces_gravity<Scalar>, q.data(), gravity.data(), result.data());
  }
  void compute_coriolis(JointState& jForces, const JointState& q, const JointState& qd) {
    this->set_motion(q, qd, JointState::Constant(Scalar(0)), nullptr);
    this->set_upwards(0);
    Result result(jForces, q, qd);
    this->run(Robot::template coriolis_forces<Scalar>, q.data(), qd.data(), result.data());
  }
};

template <class Trait, class Robot, class Inertias, class Transforms>
class InverseDynamics<Trait, Robot, Inertias, Transforms, true>
    : public InverseDynamicsBase<Trait, Robot, Inertias, Transforms> {
 public:
  using Base = InverseDynamicsBase<Trait, Robot, Inertias, Transforms>;
  using Base::Base;
  using typename Base::Acceleration;
  using typename Base::ExtForces;
  using typename Base::Force;
  using typename Base::JointState;
  using typename Base::Scalar;
  using typename Base::Velocity;

  void id(
      JointState& jForces,
      Acceleration& base_a,
      const Acceleration& g,
      const Velocity& base_v,
      const JointState& q,
      const JointState& qd,
      const JointState& qdd) {
    this->set_state(q);
    compute(jForces, base_a, g, base_v, q, qd, qdd, nullptr);
  }
  void id(
      JointState& jForces,
      Acceleration& base_a,
      const Acceleration& g,
      const Velocity& base_v,
      const JointState& q,
      const JointState& qd,
      const JointState& qdd,
      const ExtForces& fext) {
    this->set_state(q);
    compute(jForces, base_a, g, base_v, q, qd, qdd, this->data(fext));
  }
  void id(
      JointState& jForces,
      Acceleration& base_a,
      const Acceleration& g,
      const Velocity& base_v,
      const JointState& qd,
      const JointState& qdd) {
    compute(jForces, base_a, g, base_v, this->state(), qd, qdd, nullptr);
  }
  void id(
      JointState& jForces,
      Acceleration& base_a,
      const Acceleration& g,
      const Velocity& base_v,
      const JointState& qd,
      const JointState& qdd,
      const ExtForces& fext) {
    compute(jForces, base_a, g, base_v, this->state(), qd, qdd, this->data(fext));
  }

  void id_fully_actuated(
      Force& baseWrench,
      JointState& jForces,
      const Acceleration& g,
      const Velocity& base_v,
      const Acceleration& base_a,
      const JointState& q,
      const JointState& qd,
      const JointState& qdd) {
    this->set_state(q);
    compute_fully_actuated(baseWrench, jForces, g, base_v, base_a, q, qd, qdd, nullptr);
  }
  void id_fully_actuated(
      Force& baseWrench,
      JointState& jForces,
      const Acceleration& g,
      const Velocity& base_v,
      const Acceleration& base_a,
      const JointState& q,
      const JointState& qd,
      const JointState& qdd,
      const ExtForces& fext) {
    this->set_state(q);
    compute_fully_actuated(baseWrench, jForces, g, base_v, base_a, q, qd, qdd, this->data(fext));
  }
  void id_fully_actuated(
      Force& baseWrench,
      JointState& jForces,
      const Acceleration& g,
      const Velocity& base_v,
      const Acceleration& base_a,
      const JointState& qd,
      const JointState& qdd) {
    compute_fully_actuated(baseWrench, jForces, g, base_v, base_a, this->state(), qd, qdd, nullptr);
  }
  void id_fully_actuated(
      Force& baseWrench,
      JointState& jForces,
      const Acceleration& g,
      const Velocity& base_v,
      const Acceleration& base_a,
      const JointState& qd,
      const JointState& qdd,
      const ExtForces& fext) {
    compute_fully_actuated(baseWrench, jForces, g, base_v, base_a, this->state(), qd, qdd, this->data(fext));
  }

  void G_terms_fully_actuated(Force& baseWrench, JointState& jForces, const Acceleration& g, const JointState& q) {
    this->set_state(q);
    compute_gravity(baseWrench, jForces, g, q);
  }
  void G_terms_fully_actuated(Force& baseWrench, JointState& jForces, const Acceleration& g) {
    compute_gravity(baseWrench, jForces, g, this->state());
  }

  void C_terms_fully_actuated(
      Force& baseWrench,
      JointState& jForces,
      const Velocity& base_v,
      const JointState& q,
      const JointState& qd) {
    this->set_state(q);
    compute_coriolis(baseWrench, jForces, base_v, q, qd);
  }
  void C_terms_fully_actuated(Force& baseWrench, JointState& jForces, const Velocity& base_v, const JointState& qd) {
    compute_coriolis(baseWrench, jForces, base_v, this->state(), qd);
  }

 private:
  void compute(
      JointState& jForces,
      Acceleration& base_a,
      const Acceleration& g,
      const Velocity& base_v,
      const JointState& q,
      const JointState& qd,
      const JointState& qdd,
      const Scalar* external) {
    this->set_motion(q, qd, qdd, external);
    this->set_free_base(base_v, g);
    Result joints(jForces, q, qd, qdd);
    Result base(base_a, base_v, g);
    if (external)
      this->run(
          Robot::template inverse_dynamics_external<Scalar>, q.data(), qd.data(), qdd.data(), base_v.data(),
          this->linear(g), external, joints.data(), base.data());
    else
      this->run(
          Robot::template inverse_dynamics<Scalar>, q.data(), qd.data(), qdd.data(), base_v.data(), this->linear(g),
          joints.data(), base.data());
  }
  void compute_fully_actuated(
      Force& baseWrench,
      JointState& jForces,
      const Acceleration& g,
      const Velocity& base_v,
      const Acceleration& base_a,
      const JointState& q,
      const JointState& qd,
      const JointState& qdd,
      const Scalar* external) {
    this->set_motion(q, qd, qdd, external);
    this->set_base(base_v, base_a, g);
    Result joints(jForces, q, qd, qdd);
    Result base(baseWrench, base_v, base_a, g);
    if (external)
      this->run(
          Robot::template inverse_dynamics_fully_actuated_external<Scalar>, q.data(), qd.data(), qdd.data(),
          base_v.data(), base_a.data(), this->linear(g), external, joints.data(), base.data());
    else
      this->run(
          Robot::template inverse_dynamics_fully_actuated<Scalar>, q.data(), qd.data(), qdd.data(), base_v.data(),
          base_a.data(), this->linear(g), joints.data(), base.data());
  }
  void compute_gravity(Force& baseWrench, JointState& jForces, const Acceleration& g, const JointState& q) {
    const JointState zero = JointState::Constant(Scalar(0));
    const Acceleration at_rest = Acceleration::Constant(Scalar(0));
    this->set_motion(q, zero, zero, nullptr);
    this->set_base(at_rest, at_rest, g);
    Result joints(jForces, q);
    Result base(baseWrench, g);
    this->run(Robot::template gravity_forces<Scalar>, q.data(), this->linear(g), joints.data(), base.data());
  }
  void compute_coriolis(
      Force& baseWrench,
      JointState& jForces,
      const Velocity& base_v,
      const JointState& q,
      const JointState& qd) {
    const Acceleration at_rest = Acceleration::Constant(Scalar(0));
    this->set_motion(q, qd, JointState::Constant(Scalar(0)), nullptr);
    this->set_base(base_v, at_rest, at_rest);
    Result joints(jForces, q, qd);
    Result base(baseWrench, base_v);
    this->run(Robot::template coriolis_forces<Scalar>, q.data(), qd.data(), base_v.data(), joints.data(), base.data());
  }
};

}  // namespace robcogen::compatibility
