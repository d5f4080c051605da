#include "algorithm/formulation/rotor_spin.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;
using model::Quantity;
using Vector = std::array<Quantity, 3>;

bool is_constant(const Vector& v) {
  return std::all_of(v.begin(), v.end(), [](const Quantity& q) { return q.is_constant(); });
}

Vector scaled(const Quantity& factor, const Vector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

double length(const Vector& v) {
  return std::hypot(evaluate(v[0]), evaluate(v[1]), evaluate(v[2]));
}

// Removes components that are rounding errors of a vector of this length.
void drop_rounding(Vector& v, double of) {
  constexpr double kNoComponent = 1e-15;
  for (Quantity& component : v)
    if (std::abs(evaluate(component)) <= kNoComponent * of) component = Quantity();
}

auto components_of(const Vector& v) {
  return std::count_if(v.begin(), v.end(), [](const Quantity& q) { return !q.is_zero(); });
}

// The momentum of a rotor as c e + b, in axes of the carrier.
struct Split {
  Quantity along;  // c
  Vector rest;     // b
};

Split split(const Vector& momentum, const Vector& axis, const Quantity& along) {
  Split result{along, {}};
  for (std::size_t i = 0; i < 3; ++i) result.rest[i] = momentum[i] - along * axis[i];
  drop_rounding(result.rest, length(momentum));
  return result;
}

// Leaves no component of the rest along the joint's axis, or along the z axis of the carrier, which stays where it is
// when frames turn about their joints. Takes nothing along the axis if neither saves a component.
Split split(const Vector& momentum, const Vector& axis) {
  constexpr double kSmall = 0.2;  // an axis with a smaller z component would make the numbers larger
  Split best = split(momentum, axis, Quantity());
  const auto take_better = [&](Quantity along) {
    Split other = split(momentum, axis, along);
    if (components_of(other.rest) < components_of(best.rest)) best = std::move(other);
  };
  const Quantity projection = momentum[0] * axis[0] + momentum[1] * axis[1] + momentum[2] * axis[2];
  const Split across = split(momentum, axis, projection);
  if (components_of(across.rest) == 0) return across;
  if (std::abs(evaluate(axis[2])) > kSmall) take_better(momentum[2] / axis[2]);
  take_better(projection);
  return best;
}

// Adds a moment of inertia about an axis that is given in link axes.
void add_spin(model::Link& link, const Quantity& inertia, Vector axis) {
  model::Inertia& body = *link.inertia;
  if (body.reference) {
    const auto R = rotation_matrix(*body.reference);
    Vector seen;
    for (std::size_t i = 0; i < 3; ++i) seen[i] = R[0][i] * axis[0] + R[1][i] * axis[1] + R[2][i] * axis[2];
    axis = seen;
  }
  const Vector column = scaled(inertia, axis);
  body.ixx = body.ixx + column[0] * axis[0];
  body.iyy = body.iyy + column[1] * axis[1];
  body.izz = body.izz + column[2] * axis[2];
  body.ixy = body.ixy - column[0] * axis[1];
  body.ixz = body.ixz - column[0] * axis[2];
  body.iyz = body.iyz - column[1] * axis[2];
}

void take_spin(KinematicTree& tree, model::Joint& joint) {
  if (!joint.drive.rotor || !model::turns(joint.type)) return;
  const model::Rotor rotor = *joint.drive.rotor;
  const bool on_child = rotor.carrier == joint.child;
  const bool on_fixed_base = joint.parent == 0 && !tree.floating_base;
  model::Link &parent = tree.links[at(joint.parent)], &child = tree.links[at(joint.child)];
  // A rotor on a fixed base does not turn with its carrier. A link without mass properties would get a body.
  if ((rotor.carrier != joint.parent || on_fixed_base) && !on_child) return;
  if (!child.inertia || (!on_fixed_base && !parent.inertia)) return;
  const auto R = rotation_matrix(joint.placement);
  const Vector axis_in_parent = {R[0][2], R[1][2], R[2][2]};
  const Vector axis_in_child = {Quantity(), Quantity(), Quantity(1.0)};
  const Vector& axis = on_child ? axis_in_child : axis_in_parent;
  const Vector direction = rotor.axis ? rotor_axis(joint) : axis;
  const Quantity size = rotor.inertia * rotor.ratio;
  if (!is_constant(axis_in_parent) || !is_constant(direction) || !size.is_constant()) return;

  const Split momentum = rotor.axis ? split(scaled(size, direction), axis) : Split{size, {}};
  if (momentum.along.is_zero()) return;
  add_spin(child, momentum.along, axis_in_child);
  if (!on_fixed_base) add_spin(parent, -momentum.along, axis_in_parent);
  const Quantity own = joint.drive.armature + size * rotor.ratio;
  joint.drive.armature = on_child ? own + momentum.along : own - momentum.along;
  joint.drive.rotor.reset();
  if (components_of(momentum.rest) == 0) return;
  const Quantity rest(length(momentum.rest));
  joint.drive.rotor = model::Rotor{rest, Quantity(1.0), momentum.rest, rotor.carrier};
  joint.drive.armature = joint.drive.armature - rest;
}

}  // namespace

KinematicTree with_spin_in_bodies(const KinematicTree& tree) {
  KinematicTree result = tree;
  for (model::Joint& joint : result.joints) take_spin(result, joint);
  return result;
}

}  // namespace robcogen::algorithm
