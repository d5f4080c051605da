// Finds xacro instructions in a URDF: until they are expanded, the robot is incomplete.
#include <fmt/format.h>

#include "import/urdf/element_reader.h"

namespace robcogen::import::from_urdf {

namespace {

struct Instruction {
  Span span;
  std::string text;  // for a message, as in `element 'xacro:include'`
};

// Instructions in elements that are read, and in elements that are ignored: meshes, simulators, most transmissions.
struct Instructions {
  std::vector<Instruction> read, ignored;
};

bool is_expression(const std::string& value) {
  return value.find("${") != std::string::npos || value.find("$(") != std::string::npos;
}

// Older versions of xacro had no namespace.
bool is_instruction(const Element& element, bool is_top_level) {
  return element.name.starts_with("xacro:") || (is_top_level && (element.name == "macro" || element.name == "include"));
}

// Whether a child of an element that is read is read too.
bool is_read_in(const Element& parent, const Element& child) {
  static const std::map<std::string, Names> read = {
      {"robot", {"link", "joint", "loop", "coupling"}},
      {"link", {"inertial"}},
      {"inertial", {"origin", "mass", "inertia"}},
      {"joint", {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"}},
      {"loop", {"predecessor", "successor", "axis"}},
      {"predecessor", {"origin"}},
      {"successor", {"origin"}},
      {"coupling", {"predecessor", "successor", "ratio"}},
      {"transmission", {"joint", "actuator"}},
      {"actuator", {"drake:rotor_inertia", "drake:gear_ratio"}}};
  if (child.name == "transmission") return parent.name == "robot" && rotor_inertia_of(child) != nullptr;
  const auto names = read.find(parent.name);
  return names != read.end() &&
         std::find(names->second.begin(), names->second.end(), child.name) != names->second.end();
}

void collect(const Element& element, bool is_read, Instructions& found) {
  for (const Attribute& attribute : element.attributes) {
    if (!is_expression(attribute.value)) continue;
    (is_read ? found.read : found.ignored)
        .push_back({attribute.span, fmt::format("attribute '{}' of this '{}'", attribute.name, element.name)});
  }
  const bool is_robot = element.name == "robot";
  for (const Element& child : element.children) {
    if (is_instruction(child, is_robot)) {
      found.read.push_back({child.span, fmt::format("element '{}'", child.name)});
      continue;  // its content is part of the instruction
    }
    collect(child, is_read && is_read_in(element, child), found);
  }
}

std::string others(const std::vector<Instruction>& all) {
  if (all.size() == 1) return "";
  return fmt::format(" ({} more follow{})", all.size() - 1, all.size() == 2 ? "s" : "");
}

}  // namespace

bool check_expanded(const Element& root, const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
  Instructions found;
  collect(root, true, found);
  if (!found.read.empty()) {
    const Instruction& first = found.read.front();
    diagnostics
        .error(
            "unexpanded-xacro", {source, first.span},
            fmt::format(
                "{} must be expanded by xacro, which has not processed this file{}", first.text, others(found.read)))
        .hint =
        "expand it first: `xacro robot.urdf.xacro > robot.urdf`; robcogen_add_robot does so when MODEL is a .xacro";
    return false;
  }
  if (!found.ignored.empty()) {
    const Instruction& first = found.ignored.front();
    diagnostics.warning(
        "unexpanded-xacro", {source, first.span},
        fmt::format(
            "{} must be expanded by xacro, which has not processed this file{}; the elements that are read are not "
            "affected",
            first.text, others(found.ignored)));
  }
  return true;
}

}  // namespace robcogen::import::from_urdf
