// Reads the rotors behind the gears of transmissions, as written in Drake's extension of URDF.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/urdf/element_reader.h"

namespace robcogen::import::from_urdf {
namespace {

const Element* child_of(const Element& element, const char* name) {
  const auto found = std::find_if(
      element.children.begin(), element.children.end(), [&](const Element& child) { return child.name == name; });
  return found == element.children.end() ? nullptr : &*found;
}

const Attribute* attribute_of(const Element* element, const char* name) {
  return element == nullptr ? nullptr : find(*element, name);
}

class TransmissionReader {
 public:
  TransmissionReader(Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  void read(const Element& transmission) {
    const Attribute* joint = attribute_of(child_of(transmission, "joint"), "name");
    const Attribute* inertia = rotor_inertia_of(transmission);
    if (joint == nullptr || inertia == nullptr) {
      ++document_.ignored[transmission.name];
    } else if (Joint* driven = driven_by(*joint)) {
      const Element& actuator = *child_of(transmission, "actuator");
      add_armature(*driven, *inertia, attribute_of(child_of(actuator, "drake:gear_ratio"), "value"));
    }
  }

  void report() {
    if (joints_.empty()) return;
    diagnostics_.note(
        "rotor-as-armature", first_,
        fmt::format(
            "the rotor inertia times the square of the gear ratio becomes armature, which is part of the dynamics, of "
            "these joints: {}",
            joints_));
  }

 private:
  Document& document_;
  Diagnostics& diagnostics_;
  std::string joints_;
  Place first_;

  // Returns the joint of this name that a rotor turns; nullptr after a warning.
  Joint* driven_by(const Attribute& name) {
    const auto driven = std::find_if(
        document_.joints.begin(), document_.joints.end(), [&](const Joint& j) { return j.name.text == name.value; });
    const bool is_declared = driven != document_.joints.end();
    if (is_declared && is_movable(*driven)) return &*driven;
    if (is_declared && diagnostics_.has_errors()) return nullptr;  // a joint whose type is wrong counts as fixed
    Diagnostic& warning = diagnostics_.warning(
        "rotor-without-joint", {document_.source, name.span},
        fmt::format(
            "the rotor of this transmission is left out: joint '{}' is {}", name.value,
            is_declared ? name_of(driven->type) : "not declared"));
    if (is_declared) return nullptr;
    std::vector<std::string> names;
    for (const Joint& other : document_.joints) names.push_back(other.name.text);
    warning.hint = did_you_mean(name.value, names);
    return nullptr;
  }

  // The square of the ratio has no sign.
  void add_armature(Joint& driven, const Attribute& inertia, const Attribute* ratio) {
    const std::optional<Number> J = number(inertia, false);
    const std::optional<Number> N = ratio == nullptr ? Number::rational(1) : number(*ratio, true);
    if (!J || !N) return;
    driven.armature = driven.armature + *J * *N * *N;
    if (first_.source == nullptr) first_ = {document_.source, inertia.span};
    joints_ += fmt::format("{}'{}'", joints_.empty() ? "" : ", ", driven.name.text);
  }

  std::optional<Number> number(const Attribute& attribute, bool may_be_negative) {
    constexpr const char* kBlanks = " \t\n\r";
    std::string word = attribute.value;
    word.erase(0, word.find_first_not_of(kBlanks));
    word.erase(word.find_last_not_of(kBlanks) + 1);
    const std::optional<Number> value = Number::parse(word);
    if (value && std::isfinite(value->value()) && (may_be_negative || value->value() >= 0)) return value;
    diagnostics_.error(
        "bad-rotor", {document_.source, attribute.span},
        fmt::format(
            "expected a number{}, found '{}'", may_be_negative ? "" : " that is not negative", attribute.value));
    return std::nullopt;
  }
};

}  // namespace

const Attribute* rotor_inertia_of(const Element& transmission) {
  const Element* actuator = child_of(transmission, "actuator");
  return actuator == nullptr ? nullptr : attribute_of(child_of(*actuator, "drake:rotor_inertia"), "value");
}

void read_transmissions(const Element& root, Document& document, Diagnostics& diagnostics) {
  TransmissionReader reader(document, diagnostics);
  for (const Element& child : root.children)
    if (child.name == "transmission") reader.read(child);
  reader.report();
}

}  // namespace robcogen::import::from_urdf
