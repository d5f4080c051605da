// Moments of the velocities of composite bodies, from which Coriolis forces and derivatives of forces are computed.
//
// Let p be the position of a particle relative to the origin of a link that supports it. At unit rate of a coordinate,
// the particle has the velocity u = a_v + a_w x p, of which du/dt = a_v' + a_w' x p + a_w x p' in axes at rest. The
// integral of du/dt over a composite body takes l = integral of p' dm and K = integral of p' p^T dm, in addition to the
// mass m, the first moment h and the pseudo-inertia. The wrench about the origin that accelerates all particles by
// du/dt is
//     f = m a_v' + a_w' x h + a_w x l,     n = h x a_v' + I a_w' + (tr(K) 1 - K) a_w.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

// l and K of a composite body, about its link's origin in link axes.
struct MomentRates {
  Vector3 l;
  Matrix3 K;
};

// The rate of the vector from the parent's origin to the child's, in the two parts of Pose.
struct OriginRate {
  Vector3 offset;  // parent axes
  Vector3 slide;   // child axes
};

// The integrals of the composite bodies, and how their links move.
class CompositeMotion {
 public:
  CompositeMotion(const TracedRobot& robot, const std::vector<Expression>& qd, const Vector3& base_w);

  std::vector<MassProperties> composite;  // by link, as the next two
  std::vector<MomentRates> moment_rates;
  std::vector<Vector3> w;         // angular velocity, link axes
  std::vector<OriginRate> rates;  // by joint

 private:
  const TracedRobot& robot_;
  const std::vector<Expression>& qd_;

  void collect(int link, const Vector3& velocity);
};

// The integral over a composite body of a velocity field times the change du/dt of another field. It is linear in
// du/dt: Q = (n, f) multiplies (a_w', a_v'), e multiplies a_w.
struct ChangeOfMotion {
  Force Q;
  Vector3 e;
};
ChangeOfMotion to_parent(const Pose& X_PC, const OriginRate& rate, const ChangeOfMotion& x);

// The change du/dt of a velocity field: a_w, and (a_w', a_v').
struct FieldChange {
  Vector3 turning;
  Motion rate;
};
Expression dot(const ChangeOfMotion& x, const FieldChange& field);
// The wrench (n, f), above, of a change of a field.
Force wrench_of(const MassProperties& m, const MomentRates& body, const FieldChange& field);

// The form applied to the motion fields of a link that turns by w, about and along its axes.
Force on_fields_of_link(const ChangeOfMotion& x, const Vector3& w);

// (tr(K) 1 - K) v.
Vector3 times_tensor_of(const Matrix3& K, const Vector3& v);

// w x z, the rate of a link's z axis.
Vector3 rate_of_z(const Vector3& w);

// The change of the motion field of a joint whose axis turns with its link, by w.
FieldChange change_of_field(const Vector3& w, const Motion& S);
// The wrench that belongs to this change.
Force column_wrench(const MassProperties& m, const MomentRates& body, const Vector3& w, const Motion& S);
// The integral of that field, as a form of the change of others.
ChangeOfMotion row_of_joint(const MassProperties& m, const MomentRates& body, const Joint& joint, const Motion& S);

}  // namespace robcogen::algorithm
