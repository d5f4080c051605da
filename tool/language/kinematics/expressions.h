// Visits every expression in the elements of a robot, for phases that rewrite or collect expressions: the only list of
// the expressions in an element. The visitor is called with `ExpressionPtr&`, or with `const ExpressionPtr&` in a
// constant element, in the order of the canonical text, and never with an absent expression.
#pragma once

#include "language/kinematics/document.h"

namespace robcogen::language::kinematics {

template <class VectorType, class Visit>
void visit_vector(VectorType& vector, Visit visit) {
  for (auto& component : vector) visit(component);
}

template <class PlacementType, class Visit>
void visit_placement(PlacementType& placement, Visit visit) {
  visit_vector(placement.translation, visit);
  visit_vector(placement.rotation, visit);
}

template <class LinkType, class Visit>
void visit_link(LinkType& link, Visit visit) {
  if (link.inertia) {
    auto& i = *link.inertia;
    visit(i.mass);
    visit_vector(i.com, visit);
    for (auto* e : {&i.ix, &i.iy, &i.iz, &i.ixy, &i.ixz, &i.iyz}) visit(*e);
  }
  for (auto& frame : link.frames) visit_placement(frame.placement, visit);
  for (auto& instance : link.instances) {
    for (auto& argument : instance.arguments) visit(argument.value);
    if (instance.placement) visit_placement(*instance.placement, visit);
  }
}

// `Owner` is DriveAndLimits, constant or not.
template <class Owner, class Visit>
void visit_drive_and_limits(Owner& owner, Visit visit) {
  const auto visit_given = [&](auto& e) {
    if (e) visit(e);
  };
  auto& d = owner.drive;
  for (auto* e : {&d.damping, &d.friction, &d.friction_velocity, &d.armature, &d.stiffness, &d.rest}) visit_given(*e);
  if (owner.rotor) {
    visit(owner.rotor->inertia);
    visit(owner.rotor->ratio);
    if (owner.rotor->axis) visit_vector(*owner.rotor->axis, visit);
  }
  if (owner.elasticity) {
    visit(owner.elasticity->stiffness);
    visit_given(owner.elasticity->damping);
  }
  if (owner.limits.position)
    for (auto& bound : *owner.limits.position) visit(bound);
  visit_given(owner.limits.velocity);
  visit_given(owner.limits.effort);
  visit_given(owner.assembled);
}

template <class JointType, class Visit>
void visit_joint(JointType& joint, Visit visit) {
  visit_placement(joint.placement, visit);
  if (joint.pitch) visit(joint.pitch);
  visit_drive_and_limits(joint, visit);
  for (auto& coordinate : joint.coordinates) visit_drive_and_limits(coordinate, visit);
}

template <class BodyType, class Visit>
void visit_body(BodyType& body, Visit visit) {
  for (auto& link : body.links) visit_link(link, visit);
  for (auto& joint : body.joints) visit_joint(joint, visit);
  for (auto& coupling : body.couplings) visit(coupling.value);
  for (auto& loop : body.loop_joints)
    if (loop.distance) visit(loop.distance);
  for (auto& tendon : body.tendons)
    for (auto* e : {&tendon.length, &tendon.stiffness, &tendon.damping, &tendon.rest})
      if (*e) visit(*e);
}

}  // namespace robcogen::language::kinematics
