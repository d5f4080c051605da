// Reads the mass properties of links.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "import/sdf/read.h"

namespace robcogen::import::from_sdf {
namespace {

// `'a'`, `'a' and 'b'`, `'a', 'b' and 'c'`
std::string list_of(const std::vector<std::string>& names) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i)
    result += fmt::format("{}'{}'", i == 0 ? "" : i + 1 == names.size() ? " and " : ", ", names[i]);
  return result;
}

bool is_automatic(const Element& inertial) {
  const Attribute* automatic = xml::find(inertial, "auto");
  return automatic != nullptr && (automatic->value == "true" || automatic->value == "True" || automatic->value == "1");
}

void check_added_mass(const Element& inertial, const std::string& name, ElementReader& reader) {
  const Element* added = reader.child(inertial, "fluid_added_mass");
  if (added == nullptr) return;
  for (const Element& child : added->children) {
    const std::optional<Number> value = Number::parse(child.text);
    if (value && value->is_zero()) continue;
    reader.diagnostics()
        .warning(
            "mechanics-not-read", added->place, fmt::format("the fluid added mass of link '{}' is not read", name))
        .hint = "the robot moves as in air";
    return;
  }
}

}  // namespace

Inertial read_inertial(const Element& link, const std::string& name, ElementReader& reader) {
  Inertial result;
  result.mass_place = result.inertia_place = link.place;
  const Element* inertial = reader.child(link, "inertial");
  if (inertial == nullptr) {
    result.defaults = "'inertial'";
    return result;
  }
  result.mass_place = result.inertia_place = inertial->place;
  result.is_automatic = is_automatic(*inertial);
  if (result.is_automatic) return result;
  result.pose = reader.pose(*inertial, fmt::format("the inertial of link '{}'", name)).pose;
  check_added_mass(*inertial, name, reader);
  std::vector<std::string> defaults;
  if (const Element* mass = reader.child(*inertial, "mass"); mass != nullptr) {
    result.mass = reader.number(*inertial, "mass", result.mass);
    result.mass_place = xml::text_of(*mass).place;
  } else {
    defaults.emplace_back("mass");
  }
  const Element* inertia = reader.child(*inertial, "inertia");
  if (inertia == nullptr) {
    defaults.emplace_back("inertia");
  } else {
    result.inertia_place = inertia->place;
    const auto read = [&](const char* moment, Number& value) {
      if (reader.child(*inertia, moment) == nullptr && !value.is_zero()) defaults.emplace_back(moment);
      value = reader.number(*inertia, moment, value);
    };
    read("ixx", result.ixx), read("iyy", result.iyy), read("izz", result.izz);
    read("ixy", result.ixy), read("ixz", result.ixz), read("iyz", result.iyz);
  }
  result.defaults = list_of(defaults);
  return result;
}

}  // namespace robcogen::import::from_sdf
