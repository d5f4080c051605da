#include "import/urdf/joint_attributes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace robcogen::import::from_urdf {
namespace {

constexpr std::array<std::pair<JointType, const char*>, 6> kTypes = {{
    {JointType::revolute, "revolute"},
    {JointType::continuous, "continuous"},
    {JointType::prismatic, "prismatic"},
    {JointType::fixed, "fixed"},
    {JointType::floating, "floating"},
    {JointType::planar, "planar"},
}};

}  // namespace

const char* name_of(JointType type) {
  return std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& known) { return known.first == type; })->second;
}

std::optional<JointType> read_type(
    const Element& element,
    const Name& name,
    const std::vector<JointType>& types,
    Place& place,
    ElementReader& reader) {
  const Attribute* type = reader.require(element, "type");
  if (type == nullptr) return std::nullopt;
  place = reader.place(type->span);
  std::vector<std::string> names;
  for (const JointType known : types) {
    names.emplace_back(name_of(known));
    if (type->value == names.back()) return known;
  }
  const std::string hint = did_you_mean(type->value, names);
  reader.diagnostics()
      .error(
          fmt::format("unknown-{}-type", element.name), place,
          fmt::format("{} '{}' has unknown type '{}'", element.name, name.text, type->value))
      .hint = hint.empty() ? fmt::format("the types are {}", fmt::join(names, ", ")) : hint;
  return std::nullopt;
}

void read_axis(const Element& axis, const std::string& owner, std::array<Number, 3>& direction, ElementReader& reader) {
  const Attribute* xyz = reader.require(axis, "xyz");
  if (xyz == nullptr) return;
  Diagnostics& diagnostics = reader.diagnostics();
  const std::size_t errors_before = diagnostics.error_count();
  direction = reader.triple(*xyz);
  const bool is_zero = std::all_of(direction.begin(), direction.end(), [](const Number& x) { return x.is_zero(); });
  if (!is_zero || diagnostics.error_count() > errors_before) return;
  diagnostics.error(
      "zero-axis", reader.place(xyz->span), fmt::format("the axis of {} is zero: it has no direction", owner));
}

}  // namespace robcogen::import::from_urdf
