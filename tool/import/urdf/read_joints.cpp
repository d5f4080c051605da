// Reads the joints of the tree.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "import/magnitudes.h"
#include "import/urdf/joint_attributes.h"
#include "import/urdf/read.h"

namespace robcogen::import::from_urdf {
namespace {

// Reports items that do not apply to planar joints: a URDF does not say to which of the three coordinates they refer.
void report_items_of_planar(const Parts& own, const Joint& joint, ElementReader& reader) {
  if (const auto mimic = own.find("mimic"); mimic != own.end())
    reader.diagnostics().error(
        "planar-mimic", reader.place(mimic->second->span),
        fmt::format("planar joint '{}' has three coordinates and cannot mimic one", joint.name.text));
  for (const char* item : {"dynamics", "limit", "elastic"})
    if (const auto found = own.find(item); found != own.end())
      reader.diagnostics().warning(
          "planar-item", reader.place(found->second->span),
          fmt::format("'{}' of planar joint '{}' is left out: it has three coordinates", item, joint.name.text));
}

void read_independent(const Element& element, Joint& joint, ElementReader& reader) {
  const Attribute* attribute = find(element, "independent");
  if (attribute == nullptr) return;
  joint.independent_place = reader.place(attribute->span);
  const bool is_true = attribute->value == "true" || attribute->value == "True";
  if (is_true || attribute->value == "false" || attribute->value == "False") {
    joint.is_independent = is_true;
    return;
  }
  reader.diagnostics().error(
      "bad-independent", joint.independent_place,
      fmt::format("'independent' of joint '{}' is 'true' or 'false', not '{}'", joint.name.text, attribute->value));
}

// A position of the joint near which its loops close (rad, m). URDF+ does not have this attribute; other readers ignore
// it.
void read_assembled(const Element& element, Joint& joint, ElementReader& reader) {
  const Attribute* attribute = find(element, "assembled");
  if (attribute == nullptr) return;
  joint.assembled_place = reader.place(attribute->span);
  joint.assembled = reader.numbers(*attribute, 1, Range::any)[0].value();
}

Mimic read_mimic(const Element& element, ElementReader& reader) {
  Mimic result;
  result.joint = reader.name(element, "joint");
  if (const Attribute* found = find(element, "multiplier"))
    result.multiplier = reader.numbers(*found, 1, Range::any)[0];
  if (const Attribute* found = find(element, "offset")) result.offset = reader.numbers(*found, 1, Range::any)[0];
  return result;
}

Elasticity read_elasticity(const Element& element, ElementReader& reader) {
  Elasticity result;
  result.place = reader.place(element.span);
  const auto read = [&](const Attribute* found, Number& value, Place& place) {
    if (found == nullptr) return;
    value = reader.numbers(*found, 1)[0];
    place = reader.place(found->span);
  };
  read(reader.require(element, "stiffness"), result.stiffness, result.stiffness_place);
  read(find(element, "damping"), result.damping, result.damping_place);
  return result;
}

// Attributes of `dynamics` that some programs write. URDF does not say how they act.
void report_unread_dynamics(const Element& element, const Joint& joint, ElementReader& reader) {
  const auto find_nonzero = [&](const char* name) {
    const Attribute* found = find(element, name);
    const bool is_zero = found != nullptr && Number::parse(found->value).value_or(Number::rational(1)).is_zero();
    return is_zero ? nullptr : found;
  };
  const auto report = [&](const Attribute& attribute, const char* addition, const char* hint) {
    reader.diagnostics()
        .warning(
            "mechanics-not-read", reader.place(attribute.span),
            fmt::format("the '{}' of joint '{}' is not read{}", attribute.name, joint.name.text, addition))
        .hint = hint;
  };
  const bool has_reference = find(element, "spring_reference") != nullptr;
  for (const char* name : {"spring_stiffness", "stiffness"})
    if (const Attribute* stiffness = find_nonzero(name))
      report(
          *stiffness, has_reference ? ", nor is its 'spring_reference'" : "",
          "URDF has no springs; a robot document has: spring { stiffness = 20.0  rest = 0.5 }");
  if (const Attribute* inertia = find_nonzero("rotor_inertia"))
    report(
        *inertia, "",
        "write armature=\"...\": the inertia times the square of the gear ratio, in the unit of the joint");
}

// Simulators treat a negative value as zero.
Dynamics read_dynamics(const Element& element, const Joint& joint, ElementReader& reader) {
  Dynamics result;
  result.place = reader.place(element.span);
  const auto read = [&](const char* attribute) {
    const Attribute* found = find(element, attribute);
    const Number value = found == nullptr ? Number() : reader.numbers(*found, 1)[0];
    if (value.value() >= 0) return value;
    reader.diagnostics().warning(
        "negative-dynamics", reader.place(found->span),
        fmt::format(
            "the {} of joint '{}' is negative: {}; taken as zero", attribute, joint.name.text,
            print_double(value.value())));
    return Number();
  };
  result.damping = read("damping");
  result.friction = read("friction");
  result.armature = read("armature");
  if (!result.armature.is_zero()) result.armature_place = reader.place(find(element, "armature")->span);
  report_unread_dynamics(element, joint, reader);
  return result;
}

// Reads the attributes of one `limit`.
class LimitReader {
 public:
  LimitReader(const Element& element, const Joint& joint, ElementReader& reader)
      : element_(element), joint_(joint), reader_(reader) {}

  // Exporters write -1 for a limit that is not enforced.
  std::optional<Number> maximum(const char* attribute) {
    const std::optional<Number> value = number(attribute);
    if (!value || value->value() >= 0) return value;
    reader_.diagnostics().warning(
        "negative-limit", place(attribute),
        fmt::format(
            "the {} limit of joint '{}' is negative: {}; taken as unlimited", attribute, joint_.name.text,
            print_double(value->value())));
    return std::nullopt;
  }

  std::optional<Number> bound(const char* attribute) {
    const std::optional<Number> value = number(attribute);
    if (value && joint_.type == JointType::revolute && std::abs(value->value()) < model::kNoLimit)
      reader_.check_angle(*value, place(attribute), kTurnsOfJoint);
    return value;
  }

 private:
  const Element& element_;
  const Joint& joint_;
  ElementReader& reader_;

  Place place(const char* attribute) const { return reader_.place(find(element_, attribute)->span); }

  std::optional<Number> number(const char* attribute) {
    const Attribute* found = find(element_, attribute);
    if (found == nullptr) return std::nullopt;
    return reader_.numbers(*found, 1, Range::any)[0];
  }
};

Limit read_limit(const Element& element, const Joint& joint, ElementReader& reader) {
  Limit result;
  const Place own_place = reader.place(element.span);
  const Names known = {"lower", "upper", "effort", "velocity"};
  LimitReader read(element, joint, reader);
  result.lower = read.bound("lower"), result.upper = read.bound("upper");
  result.effort = read.maximum("effort"), result.velocity = read.maximum("velocity");
  Names missing;
  for (const char* maximum : {"effort", "velocity"})
    if (find(element, maximum) == nullptr) missing.push_back(maximum);
  if (!missing.empty()) {
    Diagnostic& warning = reader.diagnostics().warning(
        "missing-limit", own_place,
        fmt::format(
            "the 'limit' of joint '{}' has no '{}': taken as unlimited", joint.name.text, fmt::join(missing, "', '")));
    for (const Attribute& attribute : element.attributes)
      if (warning.hint.empty()) warning.hint = suggestion(attribute.name, element.attributes, missing, known);
  }
  const double lower = result.lower.value_or(Number()).value(), upper = result.upper.value_or(Number()).value();
  if (lower > upper && joint.type != JointType::continuous) {
    reader.diagnostics().warning(
        "crossed-limits", own_place,
        fmt::format(
            "no position of joint '{}' is within its limits: the lower is {}, the upper is {}", joint.name.text,
            print_double(lower), print_double(upper)));
  }
  return result;
}
}  // namespace

Joint read_joint(const Element& element, ElementReader& reader) {
  Joint result;
  result.name = reader.name(element, "name");
  const auto type = read_type(
      element, result.name,
      {JointType::revolute, JointType::continuous, JointType::prismatic, JointType::fixed, JointType::floating,
       JointType::planar},
      result.type_place, reader);
  if (type) result.type = *type;
  read_independent(element, result, reader);
  const Parts own =
      reader.parts(element, {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic", "elastic"});
  if (const Element* parent = reader.require_part(element, own, "parent")) result.parent = reader.name(*parent, "link");
  if (const Element* child = reader.require_part(element, own, "child")) result.child = reader.name(*child, "link");
  result.origin = reader.origin(own);
  if (const auto elastic = own.find("elastic"); type && !has_axis(result) && elastic != own.end())
    reader.diagnostics().warning(
        "mechanics-not-read", reader.place(elastic->second->span),
        fmt::format("'elastic' of {} joint '{}' is left out", name_of(*type), result.name.text));
  if (!type || !has_axis(result)) return result;  // the rest does not apply to this type
  if (const auto axis = own.find("axis"); axis != own.end())
    read_axis(*axis->second, fmt::format("joint '{}'", result.name.text), result.axis, reader);
  if (result.type == JointType::planar) {
    report_items_of_planar(own, result, reader);
    return result;
  }
  read_assembled(element, result, reader);
  if (const auto mimic = own.find("mimic"); mimic != own.end()) result.mimic = read_mimic(*mimic->second, reader);
  if (const auto dynamics = own.find("dynamics"); dynamics != own.end())
    result.dynamics = read_dynamics(*dynamics->second, result, reader), result.armature = result.dynamics->armature;
  if (const auto elastic = own.find("elastic"); elastic != own.end())
    result.elasticity = read_elasticity(*elastic->second, reader);
  if (const auto limit = own.find("limit"); limit != own.end()) {
    result.limit = read_limit(*limit->second, result, reader);
  } else if (result.type != JointType::continuous) {
    reader.diagnostics().warning(
        "missing-limit", result.name.place,
        fmt::format(
            "{} joint '{}' has no 'limit': its motion is taken as unlimited", name_of(result.type), result.name.text));
  }
  return result;
}

}  // namespace robcogen::import::from_urdf
