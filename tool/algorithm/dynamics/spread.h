// The spread of composite bodies: integrals of velocities, from which Coriolis forces and derivatives of forces are
// computed.
//
// A particle at p, relative to the origin of a link that supports it, moves by u = a_v + a_w x p per unit rate of a
// coordinate. The time derivative of u, in axes at rest, is a_v' + a_w' x p + a_w x p'. So a composite body needs
// l = integral of p' dm and K = integral of p' p^T dm in addition to mass, first moment h and pseudo-inertia. Then the
// wrench about the origin that belongs to du/dt is
//     f = m a_v' + a_w' x h + a_w x l,     n = h x a_v' + I a_w' + (tr(K) 1 - K) a_w.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

// l and K of a composite body, about its link's origin in link axes.
struct Spread {
  Vector3 l;
  Matrix3 K;
};

// The rate of the vector from the parent's origin to the child's, in the two parts of Pose.
struct OriginRate {
  Vector3 offset;  // parent axes
  Vector3 slide;   // child axes
};

// The integrals of the composite bodies, and how their links move.
class SpreadBodies {
 public:
  SpreadBodies(const TracedRobot& robot, const std::vector<Expression>& qd, const Vector3& base_w);

  std::vector<MassProperties> composite;  // by link, as the next two
  std::vector<Spread> spread;
  std::vector<Vector3> w;         // angular velocity, link axes
  std::vector<OriginRate> rates;  // by joint

 private:
  const TracedRobot& robot_;
  const std::vector<Expression>& qd_;

  void collect(int link, const Vector3& velocity);
};

// The integral of one motion field times the change of another, as a linear form of the latter: Q = (n, f) multiplies
// (a_w', a_v'), e multiplies a_w.
struct ChangeOfMotion {
  Force Q;
  Vector3 e;
};
ChangeOfMotion to_parent(const Pose& X_PC, const OriginRate& rate, const ChangeOfMotion& x);

// The argument of such a form: a_w, and (a_w', a_v').
struct FieldChange {
  Vector3 turning;
  Motion rate;
};
Expression dot(const ChangeOfMotion& x, const FieldChange& field);
// The wrench (n, f), above, of a change of a field.
Force wrench_of(const MassProperties& m, const Spread& body, const FieldChange& field);

// The form applied to the motion fields of a link that turns by w, about and along its axes.
Force on_fields_of_link(const ChangeOfMotion& x, const Vector3& w);

// (tr(K) 1 - K) v.
Vector3 multiply_by_spread(const Matrix3& K, const Vector3& v);

// w x z, the rate of a link's z axis.
Vector3 rate_of_z(const Vector3& w);

// The change of the motion field of a joint whose axis turns with its link, by w.
FieldChange change_of_field(const Vector3& w, const Motion& S);
// The wrench that belongs to this change.
Force column_wrench(const MassProperties& m, const Spread& body, const Vector3& w, const Motion& S);
// The integral of that field, as a form of the change of others.
ChangeOfMotion row_of_joint(const MassProperties& m, const Spread& body, const Joint& joint, const Motion& S);

}  // namespace robcogen::algorithm
