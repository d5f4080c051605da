// Compares the content of documents.
#include <algorithm>

#include "language/kinematics/document.h"

namespace robcogen::language::kinematics {
namespace {

bool same(const ExpressionPtr& a, const ExpressionPtr& b) {
  return a && b ? language::equal(*a, *b) : a == b;
}

bool same(const Vector& a, const Vector& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) { return same(x, y); });
}

bool same(const Placement& a, const Placement& b) {
  return same(a.translation, b.translation) && same(a.rotation, b.rotation);
}

bool same(const Inertia& a, const Inertia& b) {
  return same(a.mass, b.mass) && same(a.com, b.com) && same(a.ix, b.ix) && same(a.iy, b.iy) && same(a.iz, b.iz) &&
         same(a.ixy, b.ixy) && same(a.ixz, b.ixz) && same(a.iyz, b.iyz) &&
         a.reference.has_value() == b.reference.has_value() && (!a.reference || a.reference->text == b.reference->text);
}

bool same(const Child& a, const Child& b) {
  return a.link.text == b.link.text && a.joint.text == b.joint.text;
}

bool same(const Name& a, const Name& b) {
  return a.text == b.text;
}

bool same(const Argument& a, const Argument& b) {
  return same(a.name, b.name) && same(a.value, b.value);
}

bool same(const std::optional<Mirror>& a, const std::optional<Mirror>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const auto same_name = [](const Name& x, const Name& y) { return same(x, y); };
  return a->axis == b->axis && a->same_sense == b->same_sense &&
         std::equal(a->joints.begin(), a->joints.end(), b->joints.begin(), b->joints.end(), same_name);
}

bool same(const Frame& a, const Frame& b) {
  return a.name.text == b.name.text && same(a.placement, b.placement);
}

bool same(const Coupling& a, const Coupling& b) {
  return a.joint.text == b.joint.text && same(a.value, b.value) && a.instance == b.instance && a.loop == b.loop;
}

bool same(const Actuator& a, const Actuator& b) {
  return same(a.name, b.name) && same(a.frames[0], b.frames[0]) && same(a.frames[1], b.frames[1]);
}

bool same(const Tendon& a, const Tendon& b) {
  return same(a.name, b.name) && same(a.length, b.length) && same(a.stiffness, b.stiffness) &&
         same(a.damping, b.damping) && same(a.rest, b.rest);
}

bool same(const LoopJoint& a, const LoopJoint& b) {
  return same(a.name, b.name) && same(a.frames[0], b.frames[0]) && same(a.frames[1], b.frames[1]) &&
         same(a.type, b.type) && same(a.distance, b.distance) && same(a.branch, b.branch);
}

bool same(const Loop& a, const Loop& b);

bool same(const Instance& a, const Instance& b);
bool same(const Link& a, const Link& b);
bool same(const Joint& a, const Joint& b);
bool same(const Coordinate& a, const Coordinate& b);
bool same(const PartParameter& a, const PartParameter& b);
bool same(const Part& a, const Part& b);
bool same(const Import& a, const Import& b);

template <class T>
bool all_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
}

bool same(const Loop& a, const Loop& b) {
  return same(a.variable, b.variable) && all_same(a.instances, b.instances);
}

bool same(const Instance& a, const Instance& b) {
  return same(a.part, b.part) && same(a.name, b.name) && all_same(a.arguments, b.arguments) &&
         a.placement.has_value() == b.placement.has_value() && (!a.placement || same(*a.placement, *b.placement)) &&
         same(a.mirror, b.mirror) && a.keep.has_value() == b.keep.has_value();
}

bool same(const Link& a, const Link& b) {
  return a.name.text == b.name.text && a.is_base == b.is_base && a.floating == b.floating && a.id == b.id &&
         a.inertia.has_value() == b.inertia.has_value() && (!a.inertia || same(*a.inertia, *b.inertia)) &&
         all_same(a.children, b.children) && all_same(a.instances, b.instances) && all_same(a.frames, b.frames) &&
         a.comments == b.comments;
}

bool same(const Drive& a, const Drive& b) {
  return same(a.damping, b.damping) && same(a.friction, b.friction) && same(a.friction_velocity, b.friction_velocity) &&
         same(a.armature, b.armature) && same(a.stiffness, b.stiffness) && same(a.rest, b.rest);
}

bool same(const Rotor& a, const Rotor& b) {
  return same(a.inertia, b.inertia) && same(a.ratio, b.ratio) && a.axis.has_value() == b.axis.has_value() &&
         (!a.axis || same(*a.axis, *b.axis)) && a.carrier.has_value() == b.carrier.has_value() &&
         (!a.carrier || a.carrier->text == b.carrier->text);
}

bool same(const std::optional<Elasticity>& a, const std::optional<Elasticity>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return same(a->stiffness, b->stiffness) && same(a->damping, b->damping);
}

bool same(const Limits& a, const Limits& b) {
  const auto same_bound = [](const ExpressionPtr& x, const ExpressionPtr& y) { return same(x, y); };
  return a.position.has_value() == b.position.has_value() &&
         (!a.position || std::equal(a.position->begin(), a.position->end(), b.position->begin(), same_bound)) &&
         same(a.velocity, b.velocity) && same(a.effort, b.effort);
}

bool same_drive_and_limits(const DriveAndLimits& a, const DriveAndLimits& b) {
  return same(a.drive, b.drive) && a.rotor.has_value() == b.rotor.has_value() &&
         (!a.rotor || same(*a.rotor, *b.rotor)) && same(a.elasticity, b.elasticity) && same(a.limits, b.limits) &&
         same(a.assembled, b.assembled);
}

bool same(const Coordinate& a, const Coordinate& b) {
  return a.word.text == b.word.text && same_drive_and_limits(a, b);
}

bool same(const Joint& a, const Joint& b) {
  return a.name.text == b.name.text && a.type == b.type && a.id == b.id && same(a.placement, b.placement) &&
         same(a.pitch, b.pitch) && same_drive_and_limits(a, b) && all_same(a.coordinates, b.coordinates) &&
         a.comments == b.comments;
}

bool same(const Body& a, const Body& b) {
  return all_same(a.links, b.links) && all_same(a.joints, b.joints) && all_same(a.couplings, b.couplings) &&
         all_same(a.loops, b.loops) && a.coupling_comments == b.coupling_comments &&
         all_same(a.loop_joints, b.loop_joints) && all_same(a.independents, b.independents) &&
         all_same(a.actuators, b.actuators) && all_same(a.tendons, b.tendons) && a.loop_comments == b.loop_comments &&
         a.trailing_comments == b.trailing_comments;
}

bool same(const PartParameter& a, const PartParameter& b) {
  return same(a.name, b.name) && same(a.default_value, b.default_value);
}

bool same(const Part& a, const Part& b) {
  return same(static_cast<const Body&>(a), static_cast<const Body&>(b)) && same(a.name, b.name) &&
         all_same(a.parameters, b.parameters) && all_same(a.roots, b.roots) && a.comments == b.comments;
}

bool same(const Import& a, const Import& b) {
  return a.file == b.file && a.name.has_value() == b.name.has_value() && (!a.name || same(*a.name, *b.name)) &&
         a.comments == b.comments;
}

void remove_comments(Body& body) {
  body.trailing_comments.clear();
  for (Link& link : body.links) link.comments.clear();
  for (Joint& joint : body.joints) joint.comments.clear();
  body.coupling_comments.clear();
  body.loop_comments.clear();
}

}  // namespace

bool equal(const Document& a, const Document& b) {
  return a.robot.text == b.robot.text && a.comments == b.comments && all_same(a.imports, b.imports) &&
         all_same(a.parts, b.parts) && same(static_cast<const Body&>(a), static_cast<const Body&>(b));
}

Document without_comments(Document document) {
  document.comments.clear();
  for (Import& i : document.imports) i.comments.clear();
  for (Part& p : document.parts) {
    p.comments.clear();
    remove_comments(p);
  }
  remove_comments(document);
  return document;
}

}  // namespace robcogen::language::kinematics
