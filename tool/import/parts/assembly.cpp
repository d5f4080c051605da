#include "import/parts/assembly.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "import/parts/placements.h"
#include "model/elastic_joints.h"

namespace robcogen::import::parts {
namespace {

using kinematics::Body;
using kinematics::Child;
using kinematics::Inertia;
using kinematics::Link;
using kinematics::Name;

constexpr std::string_view kFrame = "fr_";

ExpressionPtr renamed(const ExpressionPtr& e, const std::set<std::string>& joints, const std::string& instance) {
  if (e->kind == Expression::Kind::name && joints.contains(e->name)) {
    Expression result = *e;
    result.name = element_name(instance, e->name);
    result.escaped = false;
    return std::make_shared<const Expression>(std::move(result));
  }
  if (!e->left) return e;
  Expression result = *e;
  result.left = renamed(e->left, joints, instance);
  if (e->right) result.right = renamed(e->right, joints, instance);
  return std::make_shared<const Expression>(std::move(result));
}

void name_after(Link& link, const std::string& instance) {
  link.name.text = element_name(instance, link.name.text);
  for (kinematics::Frame& frame : link.frames) frame.name.text = frame_name(instance, frame.name.text);
  if (link.inertia && link.inertia->reference)
    link.inertia->reference->text = frame_name(instance, link.inertia->reference->text);
  for (kinematics::Child& child : link.children) {
    child.link.text = element_name(instance, child.link.text);
    child.joint.text = element_name(instance, child.joint.text);
  }
}

// The mass properties of a body about the origin and in the axes of a frame. `moments` is the tensor, whose
// off-diagonal elements are the negative products.
struct MassProperties {
  ExpressionPtr mass;
  Vector com;
  Matrix moments;
};

Matrix tensor(const Inertia& i) {
  const ExpressionPtr xy = negated(i.ixy), xz = negated(i.ixz), yz = negated(i.iyz);
  return {Vector{i.ix, xy, xz}, Vector{xy, i.iy, yz}, Vector{xz, yz, i.iz}};
}

// m (|c|^2 1 - c c')
Matrix steiner(const ExpressionPtr& mass, const Vector& c) {
  const ExpressionPtr square = sum(sum(product(c[0], c[0]), product(c[1], c[1])), product(c[2], c[2]));
  Matrix m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      m[i][k] = product(mass, i == k ? difference(square, product(c[i], c[i])) : negated(product(c[i], c[k])));
  return m;
}

template <class Operation>
Matrix entrywise(const Matrix& a, const Matrix& b, Operation operation) {
  Matrix m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) m[i][k] = operation(a[i][k], b[i][k]);
  return m;
}

// Returns the mass properties in the frame in which the placement is given.
MassProperties moved(const MassProperties& own, const Placement& placement) {
  if (is_identity(placement)) return own;
  const Matrix rotation = rotation_matrix(placement.rotation);
  const Matrix about_com = entrywise(own.moments, steiner(own.mass, own.com), difference);
  MassProperties result = {own.mass, sum(placement.translation, product(rotation, own.com)), {}};
  result.moments = entrywise(
      product(product(rotation, about_com), transposed(rotation)), steiner(own.mass, result.com),
      [](const ExpressionPtr& a, const ExpressionPtr& b) { return sum(a, b); });
  return result;
}

MassProperties in_link_frame(const Link& link) {
  const Inertia& i = *link.inertia;
  const MassProperties own = {i.mass, i.com, tensor(i)};
  if (!i.reference) return own;
  for (const kinematics::Frame& frame : link.frames)
    if (frame.name.text == i.reference->text) return moved(own, frame.placement);
  return own;  // the unknown frame is reported when the document is read
}

Inertia inertia_of(const MassProperties& p, Span span) {
  Inertia result;
  result.mass = p.mass;
  result.com = p.com;
  result.ix = p.moments[0][0], result.iy = p.moments[1][1], result.iz = p.moments[2][2];
  result.ixy = negated(p.moments[0][1]), result.ixz = negated(p.moments[0][2]);
  result.iyz = negated(p.moments[1][2]);
  result.span = span;
  return result;
}

}  // namespace

std::string element_name(const std::string& instance, const std::string& name) {
  return instance + "_" + name;
}

std::string frame_name(const std::string& instance, const std::string& name) {
  if (!name.starts_with(kFrame)) return element_name(instance, name);
  return std::string(kFrame) + element_name(instance, name.substr(kFrame.size()));
}

std::vector<std::string> coordinate_names(const kinematics::Joint& joint) {
  const std::span<const std::string_view> words = kinematics::coordinate_words(joint.type);
  std::vector<std::string> names, motors;
  if (words.empty()) names.push_back(joint.name.text);
  for (const std::string_view word : words) names.push_back(joint.name.text + "_" + std::string(word));
  if (joint.elasticity) motors.push_back(model::motor_name(joint.name.text));
  for (const kinematics::Coordinate& coordinate : joint.coordinates)
    if (coordinate.elasticity) motors.push_back(model::motor_name(joint.name.text + "_" + coordinate.word.text));
  names.insert(names.end(), motors.begin(), motors.end());
  return names;
}

std::vector<kinematics::Rotor*> rotors_of(kinematics::Joint& joint) {
  std::vector<kinematics::Rotor*> rotors;
  if (joint.rotor) rotors.push_back(&*joint.rotor);
  for (kinematics::Coordinate& coordinate : joint.coordinates)
    if (coordinate.rotor) rotors.push_back(&*coordinate.rotor);
  return rotors;
}

kinematics::Limb limb_of(const Assembly& part, const kinematics::Instance& instance) {
  const std::string& name = instance.name.text;
  const auto element = [&](const std::string& own) { return kinematics::Limb::Element{own, element_name(name, own)}; };
  kinematics::Limb limb;
  limb.name = instance.name;
  limb.part = instance.part.text;
  const bool keeps_base = instance.keep && part.base;
  if (keeps_base) limb.links.push_back(element(part.base->name.text));
  for (const Link& link : part.body.links) limb.links.push_back(element(link.name.text));
  if (keeps_base)
    limb.first_link = limb.links.front().name;
  else if (!part.roots.empty())
    limb.first_link = element_name(name, part.roots.front().link.text);
  for (const kinematics::Joint& joint : part.body.joints)
    for (const std::string& own : coordinate_names(joint)) limb.joints.push_back(element(own));
  const auto add_frames = [&](const Link& link) {
    for (const kinematics::Frame& frame : link.frames)
      limb.frames.push_back({frame.name.text, frame_name(name, frame.name.text)});
  };
  if (part.base) add_frames(*part.base);
  for (const Link& link : part.body.links) add_frames(link);
  return limb;
}

void name_after(Assembly& assembly, const std::string& instance) {
  std::set<std::string> joints;
  for (const kinematics::Joint& joint : assembly.body.joints)
    for (std::string& name : coordinate_names(joint)) joints.insert(std::move(name));
  for (kinematics::Limb& limb : assembly.limbs) {
    limb.name.text = element_name(instance, limb.name.text);
    limb.first_link = element_name(instance, limb.first_link);
    for (auto* elements : {&limb.links, &limb.joints})
      for (auto& element : *elements) element.name = element_name(instance, element.name);
    for (auto& frame : limb.frames) frame.name = frame_name(instance, frame.name);
  }
  for (Link& link : assembly.body.links) name_after(link, instance);
  if (assembly.base) name_after(*assembly.base, instance);
  for (kinematics::Joint& joint : assembly.body.joints) {
    joint.name.text = element_name(instance, joint.name.text);
    for (kinematics::Rotor* rotor : rotors_of(joint))
      if (rotor->carrier) rotor->carrier->text = element_name(instance, rotor->carrier->text);
  }
  for (kinematics::Coupling& coupling : assembly.body.couplings) {
    coupling.joint.text = element_name(instance, coupling.joint.text);
    coupling.value = renamed(coupling.value, joints, instance);
  }
  const auto rename = [&](auto& between_frames) {
    between_frames.name.text = element_name(instance, between_frames.name.text);
    for (kinematics::Name& frame : between_frames.frames) frame.text = frame_name(instance, frame.text);
  };
  for (kinematics::Tendon& tendon : assembly.body.tendons) {
    tendon.name.text = element_name(instance, tendon.name.text);
    tendon.length = renamed(tendon.length, joints, instance);
  }
  for (kinematics::LoopJoint& loop : assembly.body.loop_joints) rename(loop);
  for (kinematics::Actuator& actuator : assembly.body.actuators) rename(actuator);
  for (kinematics::Name& joint : assembly.body.independents) joint.text = element_name(instance, joint.text);
  for (kinematics::Child& root : assembly.roots) {
    root.link.text = element_name(instance, root.link.text);
    root.joint.text = element_name(instance, root.joint.text);
  }
}

std::optional<Inertia> lumped(const Link& link, const Link& base, const Placement& placement) {
  if (!base.inertia) return link.inertia;
  const MassProperties added = moved(in_link_frame(base), placement);
  const Span span = link.inertia ? link.inertia->span : base.inertia->span;
  if (!link.inertia) return inertia_of(added, span);
  const MassProperties own = in_link_frame(link);
  MassProperties both = {sum(own.mass, added.mass), {}, {}};
  for (std::size_t i = 0; i < 3; ++i)
    both.com[i] = quotient(sum(product(own.mass, own.com[i]), product(added.mass, added.com[i])), both.mass);
  both.moments =
      entrywise(own.moments, added.moments, [](const ExpressionPtr& a, const ExpressionPtr& b) { return sum(a, b); });
  return inertia_of(both, span);
}

void append(Body& body, Body added) {
  std::move(added.links.begin(), added.links.end(), std::back_inserter(body.links));
  std::move(added.joints.begin(), added.joints.end(), std::back_inserter(body.joints));
  std::move(added.couplings.begin(), added.couplings.end(), std::back_inserter(body.couplings));
  std::move(added.loop_joints.begin(), added.loop_joints.end(), std::back_inserter(body.loop_joints));
  std::move(added.actuators.begin(), added.actuators.end(), std::back_inserter(body.actuators));
  std::move(added.tendons.begin(), added.tendons.end(), std::back_inserter(body.tendons));
  std::move(added.independents.begin(), added.independents.end(), std::back_inserter(body.independents));
}

void number_links(Assembly& robot) {
  std::map<std::string, Link*> links;
  int last = 0;
  for (Link& link : robot.body.links) {
    links.insert({link.name.text, &link});
    last = std::max(last, link.id.value_or(0));
  }
  std::vector<std::string> pending;
  const auto push = [&](const std::vector<Child>& children) {
    for (auto child = children.rbegin(); child != children.rend(); ++child) pending.push_back(child->link.text);
  };
  push(robot.roots);
  while (!pending.empty()) {
    const auto found = links.find(pending.back());
    pending.pop_back();
    if (found == links.end()) continue;
    Link& link = *found->second;
    links.erase(found);
    if (!link.id) link.id = ++last;
    push(link.children);
  }
}

}  // namespace robcogen::import::parts
