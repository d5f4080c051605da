// The motion of a link as regressors use it: how the velocities of its particles change.
//
// A reference velocity field r x p + v_r of a link that turns by w changes, in axes at rest, by a + U p with
// U = [rd]x + w r' - (w . r) 1; where the reference is the velocity itself, that is the acceleration of particle p
// (link_motion.h). The wrench that a field takes, f = U h + m a and n = (axial vector of U S) + h x a, is linear in the
// mass properties (m, h, S) (Atkeson, An, Hollerbach 1986; Slotine and Li 1987).
#pragma once

#include <string>
#include <vector>

#include "algorithm/spatial/joint.h"

namespace robcogen::algorithm {

// Everything in link axes; the acceleration carries gravity: a base at rest accelerates by -g.
struct ReferenceMotion {
  Vector3 w;   // angular velocity
  Vector3 r;   // reference angular velocity
  Vector3 rd;  // its rate of change
  Vector3 a;   // rate of change of the reference velocity of the link's origin, minus gravity
};

// The motion of a base, from its twist, the reference twist and the change of that in base coordinates.
ReferenceMotion base_motion(
    const Motion& velocity,
    const Motion& reference,
    const Motion& acceleration,
    const Vector3& gravity);

// The rate of a joint, and the rate and acceleration of its reference motion.
struct ReferenceRate {
  Expression qd, reference, acceleration;
};
// `rates` by joint. The first component of a spherical joint moves the child for all three.
ReferenceMotion across_joint(
    Graph& graph,
    const Joint& joint,
    const Pose& X_PC,
    const ReferenceMotion& parent,
    const std::vector<ReferenceRate>& rates);

// a + U p, by the parts of U that regressors are made of: U = P + [axis]x with a symmetric P.
class VelocityChange {
 public:
  explicit VelocityChange(const ReferenceMotion& motion);

  const Vector3& a() const { return a_; }
  const Vector3& axis() const { return axis_; }
  // An element of P off the diagonal, and the difference of two on it.
  const Expression& product(std::size_t row, std::size_t column) const { return products_[3 - row - column]; }
  Expression difference(std::size_t row, std::size_t other) const { return squares_[row] - squares_[other]; }
  Expression u(std::size_t row, std::size_t column) const;

 private:
  Vector3 a_, axis_;
  Vector3 products_;  // of the other two components
  Vector3 squares_;   // of each component
};

// named.h for the motion, and `described` for the parts of U.
ReferenceMotion named(const std::string& link, const ReferenceMotion& motion);
void describe(const VelocityChange& change, const std::string& link);

}  // namespace robcogen::algorithm
