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
    const Element* actuator = child_of(transmission, "actuator");
    const Attribute* joint = attribute_of(child_of(transmission, "joint"), "name");
    if (actuator == nullptr || joint == nullptr) return;
    const Attribute* inertia = attribute_of(child_of(*actuator, "drake:rotor_inertia"), "value");
    if (inertia == nullptr) return;
    const auto driven = std::find_if(
        document_.joints.begin(), document_.joints.end(), [&](const Joint& j) { return j.name.text == joint->value; });
    if (driven == document_.joints.end() || !is_movable(*driven)) return;
    const Attribute* ratio = attribute_of(child_of(*actuator, "drake:gear_ratio"), "value");
    const Number J = number(*inertia), N = ratio == nullptr ? Number::rational(1) : number(*ratio);
    driven->armature = driven->armature + J * N * N;
    if (first_.source == nullptr) first_ = {document_.source, inertia->span};
    joints_ += fmt::format("{}'{}'", joints_.empty() ? "" : ", ", joint->value);
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

  Number number(const Attribute& attribute) {
    const std::optional<Number> value = Number::parse(attribute.value);
    if (value && std::isfinite(value->value()) && value->value() >= 0) return *value;
    diagnostics_.error(
        "bad-rotor", {document_.source, attribute.span},
        fmt::format("expected a number that is not negative, found '{}'", attribute.value));
    return Number();
  }
};

}  // namespace

void read_transmissions(const Element& root, Document& document, Diagnostics& diagnostics) {
  TransmissionReader reader(document, diagnostics);
  for (const Element& child : root.children)
    if (child.name == "transmission") reader.read(child);
  reader.report();
}

}  // namespace robcogen::import::from_urdf
