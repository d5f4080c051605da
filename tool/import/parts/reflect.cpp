#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "import/parts/assembly.h"
#include "import/parts/placements.h"
#include "model/elastic_joints.h"

namespace robcogen::import::parts {
namespace {

using kinematics::Joint;
using kinematics::Link;
using kinematics::Name;

constexpr Signs kAllReversed = {-1, -1, -1};

// The axes to reverse in the frame of a joint's image. Equal positions give mirrored postures if the joint axis is
// reversed for a joint that turns about it, and not reversed for a joint that slides along it. If a joint turns about
// all three axes, all of them can be reversed, but not none, because the frame is right-handed.
Signs image_of(Joint::Type type, bool same_sense) {
  switch (type) {
    case Joint::Type::revolute:
    case Joint::Type::helical:
    case Joint::Type::cylindrical:
    case Joint::Type::planar:
      return reversed(same_sense ? 1 : 2);
    case Joint::Type::universal:
    case Joint::Type::spherical:
      return same_sense ? reversed(1) : kAllReversed;
    case Joint::Type::prismatic:
      break;
  }
  return reversed(1);
}

// The movement of one coordinate, about or along an axis of the joint frame.
struct Movement {
  std::string joint;  // name of the coordinate, or of a joint with one coordinate
  bool slides = false;
  std::size_t axis = 2;

  // -1 if mirrored postures have opposite positions.
  int sense(const Signs& frame) const { return slides ? frame[axis] : -frame[axis]; }
};

std::vector<Movement> movements_of(const Joint& joint) {
  const std::string& name = joint.name.text;
  const auto words = kinematics::coordinate_words(joint.type);
  if (words.empty()) return {{name, joint.type == Joint::Type::prismatic}};
  std::vector<Movement> movements;
  for (const std::string_view word : words) {
    const std::size_t axis = word.ends_with("_x") ? 0 : word.ends_with("_y") ? 1 : 2;
    movements.push_back({name + "_" + std::string(word), word.starts_with("slide"), axis});
  }
  return movements;
}

// The signs in the frame of the massless link between two coordinates, whose z axis is this axis (model/compound.h).
Signs with_z_along(std::size_t axis, Signs signs) {
  std::swap(signs[axis], signs[2]);
  return signs;
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
    for (const TurningRotor& rotor : rotors_) reflect(rotor);
    for (kinematics::Coupling& coupling : assembly_.body.couplings) reflect(coupling);
    for (kinematics::Tendon& tendon : assembly_.body.tendons) tendon.length = with_senses(tendon.length);
  }

  const std::map<std::string, Joint*>& joints() const { return joints_; }

 private:
  struct Pending {
    kinematics::Child child;
    Signs parent;
  };

  // A rotor, with properties of the joint that turns it.
  struct TurningRotor {
    kinematics::Rotor* rotor;
    bool slides;
    Signs parent;
    int sense;
  };

  Assembly& assembly_;
  Signs plane_;
  std::set<std::string> same_sense_;
  bool all_same_sense_ = false;
  std::map<std::string, Link*> links_;
  std::map<std::string, Joint*> joints_;
  std::map<std::string, Signs> axes_;  // of reflected links
  std::map<std::string, int> senses_;  // of reflected joints
  std::vector<Pending> pending_;
  std::vector<TurningRotor> rotors_;  // reflected once the axes of all carriers are known

  // Unknown names and cycles are reported when the whole document is read.
  void visit(const kinematics::Child& child, const Signs& parent) {
    const auto joint = joints_.find(child.joint.text);
    const auto link = links_.find(child.link.text);
    if (joint == joints_.end() || link == links_.end() || axes_.contains(child.link.text)) return;
    const bool same = all_same_sense_ || same_sense_.contains(child.joint.text);
    const Signs image = image_of(joint->second->type, same);
    axes_.insert({child.link.text, image});
    reflect(*joint->second, parent, image);
    reflect(*link->second, image);
    for (const kinematics::Child& next : link->second->children) pending_.push_back({next, image});
  }

  void reflect(Joint& joint, const Signs& parent, const Signs& image) {
    joint.placement = mirrored(joint.placement, parent, image);
    if (joint.pitch) joint.pitch = negated(joint.pitch);
    Signs carrier = parent;
    const auto words = kinematics::coordinate_words(joint.type);
    const std::vector<Movement> movements = movements_of(joint);
    for (std::size_t k = 0; k < movements.size(); ++k) {
      const Movement& movement = movements[k];
      const int sense = movement.sense(image);
      senses_.insert({movement.joint, sense});
      senses_.insert({model::motor_name(movement.joint), sense});
      if (words.empty()) reflect_drive(joint, movement.slides, carrier, sense);
      for (kinematics::Coordinate& coordinate : joint.coordinates)
        if (!words.empty() && coordinate.word.text == words[k])
          reflect_drive(coordinate, movement.slides, carrier, sense);
      carrier = with_z_along(movement.axis, image);
      if (k + 1 < movements.size()) axes_.insert({movement.joint + "_link", carrier});
    }
  }

  // Reflects the drive of a joint, or of one of its coordinates.
  template <class Owner>
  void reflect_drive(Owner& owner, bool slides, const Signs& carrier, int sense) {
    if (owner.rotor) rotors_.push_back({&*owner.rotor, slides, carrier, sense});
    if (sense > 0) return;
    for (ExpressionPtr* position : {&owner.drive.rest, &owner.assembled})
      if (*position) *position = negated(*position);
    if (!owner.limits.position) return;
    auto& [lower, upper] = *owner.limits.position;
    std::swap(lower, upper);
    lower = negated(lower);
    upper = negated(upper);
  }

  // An axis of rotation is an axial vector, so it is reflected with the opposite sign. A rotor without an axis of its
  // own has the joint axis, which already has this sign if the joint turns.
  void reflect(const TurningRotor& turning) const {
    kinematics::Rotor& rotor = *turning.rotor;
    if (!rotor.axis) {
      if (turning.slides) rotor.ratio = negated(rotor.ratio);
      return;
    }
    Signs signs = turning.parent;
    if (rotor.carrier) {
      const auto carrier = axes_.find(rotor.carrier->text);
      signs = carrier == axes_.end() ? plane_ : carrier->second;
    }
    for (int& sign : signs) sign *= -turning.sense;
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

  // Expresses the coupling in terms of the positions of the image.
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
          fmt::format("joint '{}' is prismatic: it follows the reflected axis in any case", name.text));
    }
  }
  reflection.run();
}

}  // namespace robcogen::import::parts
