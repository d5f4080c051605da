// Reads joints.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "import/magnitudes.h"
#include "import/sdf/read.h"

namespace robcogen::import::from_sdf {
namespace {

constexpr std::array<std::pair<JointType, const char*>, 8> kTypes = {{
    {JointType::revolute, "revolute"},
    {JointType::continuous, "continuous"},
    {JointType::prismatic, "prismatic"},
    {JointType::fixed, "fixed"},
    {JointType::ball, "ball"},
    {JointType::universal, "universal"},
    {JointType::screw, "screw"},
    {JointType::universal, "revolute2"},
}};

// Up to SDF 1.4, axes were given in the frame of the model.
constexpr int kAxesInJointFrame = 5;
// Up to SDF 1.6, an element of the axis chose between the two frames.
constexpr int kExpressedIn = 7;

std::optional<JointType> read_type(const Element& element, const Name& name, Place& place, Diagnostics& diagnostics) {
  const Attribute* type = xml::find(element, "type");
  if (type == nullptr) {
    diagnostics.error("missing-attribute", element.place, fmt::format("joint '{}' has no attribute 'type'", name.text));
    return std::nullopt;
  }
  place = type->place;
  std::vector<std::string> names;
  for (const auto& [known, known_name] : kTypes) {
    names.emplace_back(known_name);
    if (type->value == known_name) return known;
  }
  if (type->value == "gearbox") {
    diagnostics
        .error("unsupported-joint", place, fmt::format("joint '{}' is a gearbox, which is not supported", name.text))
        .hint = "remove it, and write <mimic joint=\"...\"> into the axis of the joint that the gears drive";
    return std::nullopt;
  }
  const std::string hint = did_you_mean(type->value, names);
  diagnostics
      .error("unknown-joint-type", place, fmt::format("joint '{}' has unknown type '{}'", name.text, type->value))
      .hint = hint.empty() ? fmt::format("the types are {}", fmt::join(names, ", ")) : hint;
  return std::nullopt;
}

class AxisReader {
 public:
  AxisReader(const Element& element, const Joint& joint, int version, ElementReader& reader)
      : element_(element), joint_(joint), version_(version), reader_(reader) {}

  Axis read() {
    read_direction();
    if (const Element* limit = reader_.child(element_, "limit")) read_limits(*limit);
    if (const Element* dynamics = reader_.child(element_, "dynamics")) read_dynamics(*dynamics);
    if (const Element* mimic = reader_.child(element_, "mimic")) read_mimic(*mimic);
    return std::move(axis_);
  }

 private:
  void read_direction() {
    const bool is_of_model = version_ < kAxesInJointFrame ||
                             (version_ < kExpressedIn && reader_.flag(element_, "use_parent_model_frame", false));
    if (is_of_model) axis_.expressed_in = {"__model__", element_.place};
    const Element* xyz = reader_.child(element_, "xyz");
    if (xyz == nullptr) return;
    axis_.xyz = reader_.direction(*xyz, fmt::format("joint '{}'", joint_.name.text));
    if (!is_of_model) axis_.expressed_in = ElementReader::reference(*xyz, "expressed_in");
  }

  void read_limits(const Element& limit) {
    axis_.places.position_limits = axis_.places.velocity_limit = axis_.places.effort_limit = limit.place;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (joint_.type != JointType::continuous) {
      axis_.limits.lower = reader_.limit(limit, "lower", -kInfinity);
      axis_.limits.upper = reader_.limit(limit, "upper", kInfinity);
      for (const double bound : {axis_.limits.lower, axis_.limits.upper})
        if (joint_.type == JointType::revolute && std::isfinite(bound))
          if (const std::string message = large_angle(bound, kTurnsOfJoint); !message.empty())
            reader_.diagnostics().warning("large-angle", limit.place, message);
    }
    if (axis_.limits.lower > axis_.limits.upper)
      reader_.diagnostics().warning(
          "crossed-limits", limit.place,
          fmt::format(
              "no position of joint '{}' is within its limits: the lower is {}, the upper is {}", joint_.name.text,
              print_double(axis_.limits.lower), print_double(axis_.limits.upper)));
    axis_.limits.effort = maximum(limit, "effort");
    axis_.limits.velocity = maximum(limit, "velocity");
  }

  // A negative limit is not enforced.
  double maximum(const Element& limit, const char* name) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double value = reader_.limit(limit, name, kInfinity);
    return value < 0 ? kInfinity : value;
  }

  void read_value(const Element& dynamics, const char* name, model::Quantity& value, Place& place) {
    const Element* found = reader_.child(dynamics, name);
    if (found == nullptr) return;
    place = xml::text_of(*found).place;
    value = model::Quantity(reader_.number(dynamics, name));
  }

  void read_dynamics(const Element& dynamics) {
    read_value(dynamics, "damping", axis_.drive.damping, axis_.places.damping);
    read_value(dynamics, "friction", axis_.drive.friction, axis_.places.friction);
    read_value(dynamics, "spring_stiffness", axis_.drive.stiffness, axis_.places.stiffness);
    if (!axis_.drive.stiffness.is_zero()) read_value(dynamics, "spring_reference", axis_.drive.rest, axis_.places.rest);
  }

  void read_mimic(const Element& element) {
    Mimic mimic;
    mimic.joint = ElementReader::reference(element, "joint");
    if (mimic.joint.text.empty())
      reader_.diagnostics().error("missing-attribute", element.place, "this 'mimic' has no attribute 'joint'");
    const Attribute* axis = xml::find(element, "axis");
    mimic.second_axis = axis != nullptr && axis->value == "axis2";
    mimic.multiplier = reader_.number(element, "multiplier", mimic.multiplier);
    mimic.offset = reader_.number(element, "offset");
    mimic.reference = reader_.number(element, "reference");
    axis_.mimic = mimic;
  }

  const Element& element_;
  const Joint& joint_;
  int version_;
  ElementReader& reader_;
  Axis axis_;
};

// Returns the distance per angle (m/rad). The newer element is a distance per revolution. The older one is an angle per
// distance, positive for a left-handed thread, as Gazebo has always read it.
model::Quantity read_pitch(const Element& element, const Name& name, ElementReader& reader) {
  const Number turn = Number::pi_multiple(2);
  if (reader.child(element, "screw_thread_pitch") == nullptr) {
    if (const Element* thread = reader.child(element, "thread_pitch")) {
      const Number angle_per_distance = reader.number(element, "thread_pitch", Number::rational(1));
      if (!angle_per_distance.is_zero()) return model::Quantity(-Number::rational(1) / angle_per_distance);
      reader.diagnostics().error(
          "zero-pitch", xml::text_of(*thread).place,
          fmt::format("the 'thread_pitch' of joint '{}' is zero", name.text));
    }
  }
  return model::Quantity(reader.number(element, "screw_thread_pitch", Number::rational(1)) / turn);
}

// Drake's rotor behind the gear of a joint adds to the inertia that the joint accelerates.
void read_rotor(const Element& element, Axis& axis, ElementReader& reader) {
  const Element* rotor = reader.child(element, "drake:rotor_inertia");
  if (rotor == nullptr) return;
  const Number ratio = reader.number(element, "drake:gear_ratio", Number::rational(1));
  axis.places.armature = xml::text_of(*rotor).place;
  axis.drive.armature = model::Quantity(reader.number(element, "drake:rotor_inertia") * ratio * ratio);
}

}  // namespace

const char* name_of(JointType type) {
  return std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& known) { return known.first == type; })->second;
}

std::optional<Joint> read_joint(const Element& element, const Name& name, int version, ElementReader& reader) {
  Joint result;
  result.name = name;
  const auto type = read_type(element, name, result.type_place, reader.diagnostics());
  if (type) result.type = *type;
  const Element* parent = reader.require_child(element, "parent");
  const Element* child = reader.require_child(element, "child");
  if (!type || parent == nullptr || child == nullptr) return std::nullopt;
  result.parent = ElementReader::reference(*parent);
  result.child = ElementReader::reference(*child);
  if (result.child.text == "world") {
    reader.diagnostics()
        .error("world-as-child", result.child.place, fmt::format("the world is the child of joint '{}'", name.text))
        .hint = "exchange 'parent' and 'child'";
    return std::nullopt;
  }
  const std::array<const char*, 2> kAxes = {"axis", "axis2"};
  for (std::size_t i = 0; i < axis_count(result.type); ++i) {
    const Element* axis = reader.child(element, kAxes[i]);
    result.axes.push_back(axis == nullptr ? Axis() : AxisReader(*axis, result, version, reader).read());
  }
  if (result.type == JointType::screw) result.pitch = read_pitch(element, name, reader);
  if (result.axes.size() == 1) read_rotor(element, result.axes[0], reader);
  return result;
}

}  // namespace robcogen::import::from_sdf
