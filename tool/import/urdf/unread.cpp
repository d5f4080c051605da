#include "import/urdf/unread.h"

#include <fmt/format.h>

#include <utility>

#include "import/urdf/element_reader.h"
#include "support/words.h"

namespace robcogen::import::from_urdf {

namespace {

constexpr const char* kNotRead = "mechanics-not-read";

// The text of an element without children, without blanks.
std::string text_of(const Element& element, const Source& source) {
  constexpr const char* kBlanks = " \t\n\r";
  const std::string_view text = source.text();
  const std::size_t begin = text.find('>', element.span.end), end = text.find('<', element.span.end);
  if (begin == std::string_view::npos || end == std::string_view::npos || end <= begin + 1) return "";
  std::string content(text.substr(begin + 1, end - begin - 1));
  content.erase(0, content.find_first_not_of(kBlanks));
  content.erase(content.find_last_not_of(kBlanks) + 1);
  return content;
}

bool is_zero(const std::string& text) {
  const std::optional<Number> number = Number::parse(text);
  return number && number->is_zero();
}

bool is_true(const std::string& text) {
  return text == "true" || text == "True" || (Number::parse(text) && !is_zero(text));
}

// Mass properties that belong to the link.
void find_in_shape(const Element& element, const std::string& owner, std::vector<Unread>& found) {
  for (const Element& child : element.children) {
    const bool is_mechanical = is_among({"inertial", "mass", "inertia", "dynamics", "joint", "link"}, child.name);
    if (!is_mechanical) {
      find_in_shape(child, owner, found);
      continue;
    }
    const bool is_inertial = is_among({"inertial", "mass", "inertia"}, child.name);
    add({child.span, kNotRead, fmt::format("element '{}' of this '{}' is not read", child.name, owner),
         is_inertial ? "mass properties belong in 'inertial' of 'link'" : "it belongs elsewhere", 0},
        found);
  }
}

// What Gazebo adds to a link or a joint.
std::string gazebo_meaning(const Element& child, const Source& source) {
  const std::string text = text_of(child, source);
  if (child.name == "springStiffness" || child.name == "dampingFactor")
    return is_zero(text) ? "" : "its forces are not part of the dynamics";
  if (child.name == "turnGravityOff") return is_true(text) ? "gravity acts on this link" : "";
  if (child.name == "gravity") return is_true(text) || text.empty() ? "" : "gravity acts on this link";
  if (child.name == "kinematic") return is_true(text) ? "forces move this link" : "";
  if (child.name == "joint") return "the robot lacks this joint; URDF+ closes a loop by 'loop'";
  if (child.name == "link" || child.name == "inertial") return "the robot lacks its mass";
  return "";
}

void find_in_gazebo(const Element& child, const std::string& owner, const Source& source, std::vector<Unread>& found) {
  const std::string meaning = gazebo_meaning(child, source);
  if (!meaning.empty())
    add({child.span, kNotRead, fmt::format("element '{}' of this '{}' is not read", child.name, owner), meaning, 0},
        found);
}

// The settings with which MuJoCo reads a URDF.
void find_in_mujoco(const Element& mujoco, std::vector<Unread>& found) {
  for (const Element& child : mujoco.children) {
    if (child.name != "compiler") continue;
    for (const Attribute& a : child.attributes) {
      const bool changes_masses = is_among({"boundmass", "boundinertia", "settotalmass"}, a.name) && !is_zero(a.value);
      const bool is_set = a.name == "inertiafromgeom" && a.value == "true";
      if (changes_masses || is_set)
        add({a.span, kNotRead, fmt::format("attribute '{}' of this 'compiler' is not read", a.name),
             "MuJoCo changes masses or moments by it", 0},
            found);
    }
  }
}

}  // namespace

void add(Unread finding, std::vector<Unread>& found) {
  const auto same =
      std::find_if(found.begin(), found.end(), [&](const Unread& f) { return f.message == finding.message; });
  if (same == found.end()) {
    finding.count = 1;
    found.push_back(std::move(finding));
  } else {
    ++same->count;
  }
}

void find_mechanics(const Element& element, const Source& source, std::vector<Unread>& found) {
  if (element.name == "visual" || element.name == "collision") find_in_shape(element, element.name, found);
  if (element.name == "gazebo")
    for (const Element& child : element.children) find_in_gazebo(child, element.name, source, found);
  if (element.name == "gravity" || element.name == "kinematic") find_in_gazebo(element, "link", source, found);
  if (element.name == "mujoco") find_in_mujoco(element, found);
}

}  // namespace robcogen::import::from_urdf
