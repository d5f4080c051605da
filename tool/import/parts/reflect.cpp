#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "import/parts/assembly.h"
#include "import/parts/placements.h"

namespace robcogen::import::parts {
namespace {

using kinematics::Joint;
using kinematics::Link;
using kinematics::Name;

// What becomes of a joint: the axes of its frame, and its position.
struct Image {
  Signs frame;
  int sense;  // -1: mirrored postures have opposite positions
};

Image image_of(Joint::Type type, bool same_sense) {
  switch (type) {
    case Joint::Type::revolute:
    case Joint::Type::helical:
      return same_sense ? Image{reversed(1), -1} : Image{reversed(2), 1};
    case Joint::Type::prismatic:
      return {reversed(1), 1};
    case Joint::Type::cylindrical:
    case Joint::Type::universal:
    case Joint::Type::planar:
    case Joint::Type::spherical:
      break;  // refused
  }
  return {reversed(1), 1};
}

bool slides(Joint::Type type) {
  return type == Joint::Type::prismatic;
}

class Reflection {
 public:
  Reflection(Assembly& assembly, const kinematics::Mirror& mirror)
      : assembly_(assembly), plane_(reversed(mirror.axis)) {
    for (const Name& joint : mirror.joints) same_sense_.insert(joint.text);
    all_same_sense_ = mirror.same_sense && mirror.joints.empty();
    for (Link& link : assembly.body.links) links_.insert({link.name.text, &link});
    for (Joint& joint : assembly.body.joints) joints_.insert({joint.name.text, &joint});
  }

  void run() {
    if (assembly_.base) reflect(*assembly_.base, plane_);
    for (const kinematics::Child& root : assembly_.roots) pending_.push_back({root, plane_});
    while (!pending_.empty()) {
      const auto [child, parent] = pending_.back();
      pending_.pop_back();
      visit(child, parent);
    }
    for (kinematics::Coupling& coupling : assembly_.body.couplings) reflect(coupling);
  }

  const std::map<std::string, Joint*>& joints() const { return joints_; }

 private:
  struct Pending {
    kinematics::Child child;
    Signs parent;
  };

  Assembly& assembly_;
  Signs plane_;
  std::set<std::string> same_sense_;
  bool all_same_sense_ = false;
  std::map<std::string, Link*> links_;
  std::map<std::string, Joint*> joints_;
  std::map<std::string, Signs> axes_;  // of links that were reflected
  std::map<std::string, int> senses_;  // of joints that were reflected
  std::vector<Pending> pending_;

  // Names that lead nowhere, or in a circle, are reported when the document is read as a whole.
  void visit(const kinematics::Child& child, const Signs& parent) {
    const auto joint = joints_.find(child.joint.text);
    const auto link = links_.find(child.link.text);
    if (joint == joints_.end() || link == links_.end() || axes_.contains(child.link.text)) return;
    const bool same = all_same_sense_ || same_sense_.contains(child.joint.text);
    const Image image = image_of(joint->second->type, same);
    axes_.insert({child.link.text, image.frame});
    senses_.insert({child.joint.text, image.sense});
    reflect(*joint->second, parent, image);
    reflect(*link->second, image.frame);
    for (const kinematics::Child& next : link->second->children) pending_.push_back({next, image.frame});
  }

  void reflect(Joint& joint, const Signs& parent, const Image& image) const {
    joint.placement = mirrored(joint.placement, parent, image.frame);
    if (joint.pitch) joint.pitch = negated(joint.pitch);
    if (joint.rotor) reflect(*joint.rotor, joint, parent, image.sense);
    if (image.sense > 0) return;
    if (joint.drive.rest) joint.drive.rest = negated(joint.drive.rest);
    if (!joint.limits.position) return;
    auto& [lower, upper] = *joint.limits.position;
    std::swap(lower, upper);
    lower = negated(lower);
    upper = negated(upper);
  }

  // An axis of rotation is reflected with the opposite sign. Without an axis it is that of the joint, which has this
  // sign where the joint turns.
  void reflect(kinematics::Rotor& rotor, const Joint& joint, const Signs& parent, int sense) const {
    if (!rotor.axis) {
      if (slides(joint.type)) rotor.ratio = negated(rotor.ratio);
      return;
    }
    Signs signs = parent;
    if (rotor.carrier) {
      const auto carrier = axes_.find(rotor.carrier->text);
      signs = carrier == axes_.end() ? plane_ : carrier->second;
    }
    for (int& sign : signs) sign *= -sense;
    rotor.axis = with_signs(signs, *rotor.axis);
  }

  static void reflect(Link& link, const Signs& axes) {
    std::map<std::string, Signs> frames;
    for (kinematics::Frame& frame : link.frames) {
      const Signs image = nearest_image(frame.placement, axes);
      frame.placement = mirrored(frame.placement, axes, image);
      frames.insert({frame.name.text, image});
    }
    if (!link.inertia) return;
    kinematics::Inertia& i = *link.inertia;
    const auto reference = i.reference ? frames.find(i.reference->text) : frames.end();
    const Signs signs = reference == frames.end() ? axes : reference->second;
    i.com = with_signs(signs, i.com);
    if (signs[0] * signs[1] < 0) i.ixy = negated(i.ixy);
    if (signs[0] * signs[2] < 0) i.ixz = negated(i.ixz);
    if (signs[1] * signs[2] < 0) i.iyz = negated(i.iyz);
  }

  // In terms of the positions of the image.
  void reflect(kinematics::Coupling& coupling) const {
    coupling.value = with_senses(coupling.value);
    const auto sense = senses_.find(coupling.joint.text);
    if (sense != senses_.end() && sense->second < 0) coupling.value = negated(coupling.value);
  }

  ExpressionPtr with_senses(const ExpressionPtr& e) const {
    if (e->kind == Expression::Kind::name) {
      const auto sense = senses_.find(e->name);
      return sense != senses_.end() && sense->second < 0 ? negated(e) : e;
    }
    if (!e->left) return e;
    const ExpressionPtr left = with_senses(e->left), right = e->right ? with_senses(e->right) : nullptr;
    return left == e->left && right == e->right ? e : with_operands(*e, left, right);
  }
};

}  // namespace

void reflect(
    Assembly& assembly,
    const kinematics::Mirror& mirror,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics) {
  Reflection reflection(assembly, mirror);
  std::vector<std::string> names;
  for (const auto& [name, joint] : reflection.joints()) names.push_back(name);
  for (const Name& name : mirror.joints) {
    const auto joint = reflection.joints().find(name.text);
    if (joint == reflection.joints().end()) {
      diagnostics.error("unknown-joint", {source, name.span}, fmt::format("the part has no joint '{}'", name.text))
          .hint = did_you_mean(name.text, names);
    } else if (slides(joint->second->type)) {
      diagnostics.warning(
          "sense-of-slide", {source, name.span},
          fmt::format("joint '{}' slides: it follows the reflected axis in any case", name.text));
    }
  }
  for (const kinematics::Joint& joint : assembly.body.joints)
    if (joint.type == Joint::Type::spherical || !kinematics::coordinate_words(joint.type).empty())
      diagnostics.error(
          "mirrored-coordinates", {source, joint.name.span},
          fmt::format("joint '{}' has several coordinates: a part with it cannot be mirrored", joint.name.text));
  reflection.run();
}

}  // namespace robcogen::import::parts
