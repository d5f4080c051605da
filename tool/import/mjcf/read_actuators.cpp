// Reads what actuators add to the dynamics of joints: the inertia of their rotors, and damping.
#include <fmt/format.h>

#include <algorithm>

#include "import/mjcf/read.h"

namespace robcogen::import::from_mjcf {

namespace {

class ActuatorReader {
 public:
  ActuatorReader(const Defaults& defaults, Document& document, Diagnostics& diagnostics)
      : defaults_(defaults), document_(document), diagnostics_(diagnostics), values_(diagnostics) {}

  void read(const Element& given) {
    if (!is_actuator(given.name) && given.name != "plugin") return;
    const Element e = defaults_.resolved(given, nullptr, "actuator");
    const Attribute* joint = find(e, "joint");
    if (joint == nullptr) joint = find(e, "jointinparent");
    const Attribute* tendon = find(e, "tendon");
    const bool is_read = joint == nullptr && tendon != nullptr && pull_tendon(e, *tendon, document_, diagnostics_);
    if (!is_read) ++document_.ignored["actuator/" + given.name];
    if (joint != nullptr) mark(*joint);
    const Attribute* armature = nonzero(e, "armature");
    const Attribute* damping = nonzero(e, "damping");
    if (armature == nullptr && damping == nullptr) return;
    if (joint == nullptr)
      report_other_target(e, armature != nullptr ? *armature : *damping);
    else
      add(e, *joint, armature, damping);
  }

 private:
  const Attribute* nonzero(const Element& e, const char* name) {
    const Attribute* found = find(e, name);
    return found != nullptr && has_nonzero(*found, diagnostics_) ? found : nullptr;
  }

  void mark(const Attribute& target) {
    for (Body& body : document_.bodies)
      for (Joint& joint : body.joints) joint.is_pulled = joint.is_pulled || is_named(joint, target.value);
  }

  // MuJoCo refuses these attributes for other targets than joints and tendons.
  void report_other_target(const Element& e, const Attribute& attribute) {
    const bool has_tendon = find(e, "tendon") != nullptr;
    diagnostics_.warning(
        "actuator-forces", attribute.place,
        fmt::format(
            "the {} of this '{}' is not part of the dynamics: its target is {}", attribute.name, e.name,
            has_tendon ? "a tendon" : "not a joint"));
  }

  void add(const Element& e, const Attribute& target, const Attribute* armature, const Attribute* damping) {
    // Further numbers of the gear apply to directions of a ball joint.
    const Attribute* gear = find(e, "gear");
    const Number ratio = gear == nullptr ? Number::rational(1) : values_.numbers(*gear, 1, 6)[0];
    const Number square = ratio * ratio;
    bool is_known = false;
    std::vector<std::string> names;
    for (Body& body : document_.bodies) {
      if (body.floats() && body.free_joint->written.text == target.value) {
        is_known = true;
        report_free(e, armature != nullptr ? *armature : *damping);
      }
      for (Joint& joint : body.joints) {
        names.push_back(joint.name.text);
        if (!is_named(joint, target.value)) continue;
        is_known = true;
        if (armature != nullptr) add(*armature, square, joint.drive.armature, joint.places.armature);
        // `springdamper` replaces the damping of the joint, but not that of the actuator.
        if (damping != nullptr) add(*damping, square, joint.added_damping, joint.places.damping);
      }
    }
    if (is_known) return;
    diagnostics_.error("actuator-joint", target.place, fmt::format("joint '{}' is not declared", target.value)).hint =
        did_you_mean(target.value, names);
  }

  void add(const Attribute& attribute, const Number& square, model::Quantity& sum, Place& place) {
    const std::vector<Number> n = values_.numbers(attribute, 1, 3);
    if (std::any_of(n.begin() + 1, n.end(), [](const Number& x) { return !x.is_zero(); }))
      diagnostics_
          .error(
              "unsupported-attribute", attribute.place,
              fmt::format("this '{}' is a polynomial, which is not supported", attribute.name))
          .hint = "write one number, for a linear force";
    sum = sum + quantity(square * n[0]);
    if (!place.source) place = attribute.place;
  }

  void report_free(const Element& e, const Attribute& attribute) {
    diagnostics_.warning(
        "free-joint-drive", attribute.place,
        fmt::format("the {} of this '{}' acts on a free joint and is left out", attribute.name, e.name));
  }

  const Defaults& defaults_;
  Document& document_;
  Diagnostics& diagnostics_;
  Values values_;
};

}  // namespace

void read_actuators(const Element& section, const Defaults& defaults, Document& document, Diagnostics& diagnostics) {
  ActuatorReader reader(defaults, document, diagnostics);
  for (const Element& given : section.children) reader.read(given);
}

}  // namespace robcogen::import::from_mjcf
