#include "import/sdf/element_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "import/magnitudes.h"
#include "import/rotation_matrix.h"

namespace robcogen::import::from_sdf {
namespace {

constexpr std::array<const char*, 3> kAngleNames = {"roll", "pitch", "yaw"};
constexpr double kTurnsOfPose = 1.0;

// The number, where `inf` is infinite; nullopt if it is neither.
std::optional<double> infinite(std::string text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.erase(0, 1);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (text != "inf" && text != "infinity") return std::nullopt;
  return is_negative ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

bool is_zero(const Number& number) {
  return number.is_zero();
}

}  // namespace

const Element* ElementReader::child(const Element& element, const std::string& name) const {
  const Element* first = nullptr;
  for (const Element& child : element.children) {
    if (child.name != name) continue;
    if (first != nullptr) {
      diagnostics_
          .warning(
              "repeated-element", child.place,
              fmt::format("this '{}' has a second '{}', which is ignored", element.name, name))
          .notes.push_back({first->place, "the first one is here"});
      break;
    }
    first = &child;
  }
  return first;
}

const Element* ElementReader::require_child(const Element& element, const std::string& name) const {
  const Element* found = child(element, name);
  if (found == nullptr)
    diagnostics_.error("missing-element", element.place, fmt::format("this '{}' has no '{}'", element.name, name))
        .hint = fmt::format("write <{0}>...</{0}>", name);
  return found;
}

Name ElementReader::name(const Element& element) const {
  const Attribute* found = xml::find(element, "name");
  if (found == nullptr || found->value.empty()) {
    diagnostics_.error(
        "missing-attribute", found == nullptr ? element.place : found->place,
        fmt::format("this '{}' has no name", element.name));
    return {"", element.place};
  }
  const bool is_reserved = found->value == "world" || (found->value.starts_with("__") && found->value.ends_with("__"));
  if (is_reserved)
    diagnostics_.error(
        "reserved-name", found->place,
        fmt::format("'{}' is a name that SDF reserves for its own frames", found->value));
  return {found->value, found->place};
}

Name ElementReader::reference(const Element& element, const char* attribute) {
  const Attribute* found = xml::find(element, attribute);
  return found == nullptr ? Name{"", element.place} : Name{found->value, found->place};
}

Name ElementReader::reference(const Element& element) {
  const Attribute text = xml::text_of(element);
  return {text.value, text.place};
}

bool ElementReader::flag(const Attribute& value, bool otherwise) const {
  for (const char* word : {"true", "True", "TRUE", "1"})
    if (value.value == word) return true;
  for (const char* word : {"false", "False", "FALSE", "0"})
    if (value.value == word) return false;
  diagnostics_.error(
      "not-a-flag", value.place, fmt::format("'{}' is 'true' or 'false', not '{}'", value.name, value.value));
  return otherwise;
}

const Element* ElementReader::child_with_value(const Element& element, const char* name) const {
  const Element* found = child(element, name);
  if (found == nullptr || !found->text.empty()) return found;
  diagnostics_.warning(
      "empty-element", found->place, fmt::format("this '{}' is empty, and taken as if it were not there", name));
  return nullptr;
}

bool ElementReader::flag(const Element& element, const char* name, bool otherwise) const {
  const Element* found = child_with_value(element, name);
  return found == nullptr ? otherwise : flag(xml::text_of(*found), otherwise);
}

Number ElementReader::number(const Element& element, const char* name, const Number& otherwise) {
  const Element* found = child_with_value(element, name);
  if (found == nullptr) return otherwise;
  return values_.read(xml::text_of(*found), 1, 1).value_or(std::vector<Number>{otherwise})[0];
}

double ElementReader::limit(const Element& element, const char* name, double otherwise) {
  const Element* found = child_with_value(element, name);
  if (found == nullptr) return otherwise;
  const Attribute text = xml::text_of(*found);
  if (const auto value = infinite(text.value)) return *value;
  const std::optional<Number> number = Number::parse(text.value);
  if (!number) {
    values_.read(text, 1, 1);  // reports it
    return otherwise;
  }
  const double value = number->value();
  if (std::abs(value) < model::kNoLimit) return value;
  return value < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

std::array<Number, 3> ElementReader::triple(const Element& element) {
  const std::vector<Number> n = values_.numbers(xml::text_of(element), 3, 3);
  return {n[0], n[1], n[2]};
}

std::array<Number, 3> ElementReader::direction(const Element& element, const std::string& owner) {
  const std::size_t errors_before = diagnostics_.error_count();
  std::array<Number, 3> result = triple(element);
  if (!std::all_of(result.begin(), result.end(), is_zero)) return result;
  if (diagnostics_.error_count() == errors_before)
    diagnostics_.error(
        "zero-axis", xml::text_of(element).place, fmt::format("the axis of {} is zero: it has no direction", owner));
  return {Number(), Number(), Number::rational(1)};
}

Rotation ElementReader::rotation(const Element& pose, const std::vector<Number>& values, const std::string& owner) {
  const Attribute text = xml::text_of(pose);
  if (values.size() == 7) {
    const std::array<long double, 4> wxyz = {
        values[6].value(), values[3].value(), values[4].value(), values[5].value()};
    if (wxyz != std::array<long double, 4>()) return rotation_of_quaternion(wxyz);
    diagnostics_.error("no-direction", text.place, fmt::format("the quaternion of {} is zero", owner));
    return {};
  }
  const Attribute* degrees = xml::find(pose, "degrees");
  const bool is_in_degrees = degrees != nullptr && flag(*degrees, false);
  std::array<Number, 3> angles = {values[3], values[4], values[5]};
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_in_degrees) {
      angles[i] = angles[i] * Number::pi_multiple(1, 180);
      continue;
    }
    if (const std::string message = large_angle(angles[i].value(), kTurnsOfPose); !message.empty())
      diagnostics_.warning("large-angle", text.place, message).hint = "degrees=\"true\" of 'pose' makes them degrees";
    snapper_.treat(angles[i], text.place, kAngleNames[i], fmt::format("the pose of {}", owner));
  }
  return rotation_of_rpy(angles);
}

ReadPose ElementReader::pose(const Element& element, const std::string& owner) {
  const Element* found = child(element, "pose");
  if (found == nullptr) return {};
  ReadPose result;
  result.relative_to = reference(*found, "relative_to");
  if (result.relative_to.text.empty()) result.relative_to = reference(*found, "frame");  // SDF 1.6
  const std::size_t form = values_.word(*found, "rotation_format", {"euler_rpy", "quat_xyzw"}, 0);
  if (found->text.empty()) return result;
  const std::size_t count = form == 0 ? 6 : 7;
  const auto values = values_.read(xml::text_of(*found), count, count);
  if (!values) return result;
  for (std::size_t i = 0; i < 3; ++i) result.pose.translation[i] = model::Quantity((*values)[i]);
  result.pose.rotation = rotation(*found, *values, owner);
  return result;
}

}  // namespace robcogen::import::from_sdf
