#include "algorithm/identification/reference_motion.h"

#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

bool same_vectors(const Vector3& a, const Vector3& b) {
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// Whether the reference is the motion itself: then products of both are symmetric.
bool is_actual(const ReferenceMotion& motion) {
  return same_vectors(motion.w, motion.r);
}

Vector3 times_u(const ReferenceMotion& motion, const Vector3& p) {
  const VelocityChange change(motion);
  Vector3 result;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      if (!p[c].is_zero()) result[r] += change.u(r, c) * p[c];
  return result;
}

// Adds the motion of the three components of a spherical joint, about axes of the child. The reference turns with the
// child: its rate of change is that of its components in axes of the child, plus w x r.
void turn(ReferenceMotion& child, const ReferenceRate* components, bool parent_is_actual) {
  Vector3 w, r, rd;
  for (std::size_t k = 0; k < 3; ++k) {
    w[k] = components[k].qd;
    r[k] = components[k].reference;
    rd[k] = components[k].acceleration;
  }
  child.rd += cross(child.w, r);
  if (!parent_is_actual || !same_vectors(w, r)) child.rd += cross(w, r);
  child.rd += rd;
  child.w += w;
  child.r += r;
}

}  // namespace

ReferenceMotion base_motion(
    const Motion& velocity,
    const Motion& reference,
    const Motion& acceleration,
    const Vector3& gravity) {
  const Vector3 &w = velocity.angular, &r = reference.angular;
  const Vector3 free = acceleration.linear - gravity;
  return {
      w, r, same_vectors(w, r) ? acceleration.angular : acceleration.angular + cross(w, r),
      free + cross(w, reference.linear)};
}

ReferenceMotion across_joint(
    Graph& graph,
    const Joint& joint,
    const Pose& X_PC,
    const ReferenceMotion& parent,
    const std::vector<ReferenceRate>& rates) {
  if (joint.is_spherical() && joint.axis > 0) return parent;
  ReferenceMotion child;
  child.w = to_child(X_PC.rotation, parent.w);
  child.r = to_child(X_PC.rotation, parent.r);
  child.rd = to_child(X_PC.rotation, parent.rd);
  child.a = to_child(X_PC.rotation, parent.a + times_u(parent, X_PC.offset));
  if (joint.is_spherical()) {
    turn(child, &rates[at(joint.index)], is_actual(parent));
    return child;
  }
  const ReferenceRate& rate = rates[at(joint.index)];
  const bool actual = is_actual(parent) && rate.qd == rate.reference;
  const Motion S = subspace(joint, graph);
  child.rd += cross(child.w, rate.reference * S.angular);
  child.rd += rate.acceleration * S.angular;
  if (actual) {
    child.a += cross(child.w, (rate.qd + rate.qd) * S.linear);
  } else {
    child.a += cross(child.r, rate.qd * S.linear);
    child.a += cross(child.w, rate.reference * S.linear);
  }
  child.a += rate.acceleration * S.linear;
  child.w += rate.qd * S.angular;
  child.r += rate.reference * S.angular;
  const Vector3 slide{Expression(), Expression(), X_PC.slide};
  child.a += times_u(child, slide);
  return child;
}

VelocityChange::VelocityChange(const ReferenceMotion& motion) : a_(motion.a), axis_(motion.rd) {
  const Vector3 &w = motion.w, &r = motion.r;
  for (std::size_t i = 0; i < 3; ++i) squares_[i] = w[i] * r[i];
  if (is_actual(motion)) {
    for (std::size_t i = 0; i < 3; ++i) products_[i] = w[(i + 1) % 3] * w[(i + 2) % 3];
    return;
  }
  // w r' is not symmetric: half of its difference from its transpose goes to the axis.
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Expression jk = w[j] * (0.5 * r[k]), kj = w[k] * (0.5 * r[j]);
    products_[i] = jk + kj;
    axis_[i] += kj - jk;
  }
}

Expression VelocityChange::u(std::size_t row, std::size_t column) const {
  if (row == column) return -(squares_[(row + 1) % 3] + squares_[(row + 2) % 3]);
  const std::size_t other = 3 - row - column;
  return column == (row + 1) % 3 ? products_[other] - axis_[other] : products_[other] + axis_[other];
}

ReferenceMotion named(const std::string& link, const ReferenceMotion& motion) {
  named("w", link, motion.w);
  if (!is_actual(motion)) named("r", link, motion.r);
  named(is_actual(motion) ? "wd" : "rd", link, motion.rd);
  named("a", link, motion.a);
  return motion;
}

void describe(const VelocityChange& change, const std::string& link) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      described_u(link, r, c, change.u(r, c));
      if (c > r) described_product_of_w(link, r, c, change.product(r, c));
    }
  described("", {link, "axis"}, change.axis());
}

}  // namespace robcogen::algorithm
