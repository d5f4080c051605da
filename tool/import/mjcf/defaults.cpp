#include "import/mjcf/defaults.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace robcogen::import::from_mjcf {

namespace {

bool is_quaternion(const Attribute& attribute) {
  return attribute.name == "quat";
}

// One of the other four ways to give an orientation.
bool is_alternative(const Attribute& attribute) {
  return is_orientation(attribute) && !is_quaternion(attribute);
}

// An element gives its orientation in one way only, so its own replaces the inherited one. In MuJoCo, however, a `quat`
// does not replace an alternative to it, and has no effect.
void merge_orientations(std::vector<Attribute>& own, std::vector<Attribute>& inherited, Diagnostics& diagnostics) {
  const auto quaternion = std::find_if(own.begin(), own.end(), is_quaternion);
  const bool has_alternative = std::any_of(own.begin(), own.end(), is_alternative);
  const auto prevails = std::find_if(inherited.begin(), inherited.end(), is_alternative);
  if (has_alternative || (quaternion != own.end() && prevails == inherited.end())) {
    std::erase_if(inherited, is_orientation);
  } else if (quaternion != own.end()) {
    Diagnostic& warning = diagnostics.warning(
        "quat-without-effect", quaternion->place,
        fmt::format("this 'quat' has no effect: the '{}' of a default prevails, as in MuJoCo", prevails->name));
    warning.notes.push_back({prevails->place, "the default is here"});
    warning.hint = fmt::format("write the orientation as '{}'", prevails->name);
    own.erase(quaternion);
  }
}

// A `size` with fewer numbers than the inherited one replaces the first of them.
std::string merged_size(const std::string& own, const std::string& inherited) {
  std::istringstream own_words(own), words(inherited);
  std::string result = own, word;
  for (std::string replaced; own_words >> word;) words >> replaced;
  while (words >> word) result += " " + word;
  return result;
}

// The attributes of `own`, then those of `inherited` that `own` does not have.
std::vector<Attribute> merged(std::vector<Attribute> own, std::vector<Attribute> inherited, Diagnostics& diagnostics) {
  merge_orientations(own, inherited, diagnostics);
  const std::size_t count = own.size();
  for (const Attribute& a : inherited) {
    const auto end = own.begin() + static_cast<std::ptrdiff_t>(count);
    const auto same = std::find_if(own.begin(), end, [&](const Attribute& other) { return other.name == a.name; });
    if (same == end)
      own.push_back(a);
    else if (a.name == "size")
      same->value = merged_size(same->value, a.value);
  }
  return own;
}

}  // namespace

const std::vector<std::string>& actuator_names() {
  static const std::vector<std::string> names = {"general",  "motor",  "position", "velocity", "intvelocity", "damper",
                                                 "cylinder", "muscle", "adhesion", "dcmotor",  "orientation", "pid"};
  return names;
}

bool is_actuator(const std::string& element) {
  return std::find(actuator_names().begin(), actuator_names().end(), element) != actuator_names().end();
}

Defaults::Defaults(const Element& root, Diagnostics& diagnostics) : diagnostics_(diagnostics) {
  classes_.push_back({"main", {}, {}});
  for (const Element& section : root.children) {
    if (section.name != "default") continue;
    const Attribute* name = find(section, "class");
    if (name != nullptr && !name->value.empty()) rename_top(*name);
    if (!classes_[0].place.source) classes_[0].place = section.place;
    read(section, 0);
  }
}

// All top-level sections belong to one class. As in MuJoCo 2, its name is the last one that they give; MuJoCo 3 accepts
// only `main`.
void Defaults::rename_top(const Attribute& name) {
  Class& top = classes_[0];
  if (top.place.source && name.value != top.name) {
    Diagnostic& warning = diagnostics_.warning(
        "second-default-class", name.place,
        fmt::format(
            "'{}' is not a class of its own: the attributes of this section apply to the whole model, as in MuJoCo",
            name.value));
    warning.notes.push_back({top.place, fmt::format("they are added to those of '{}'", top.name)});
    warning.hint = "nest a 'default' of this class in the other one";
  }
  top.name = name.value;
  top.place = name.place;
}

// A nested class starts with all attributes of the enclosing class, including those that stand after it.
void Defaults::read(const Element& section, std::size_t own) {
  for (const Element& element : section.children) {
    if (element.name == "default") continue;
    const std::string kind = is_actuator(element.name) ? "actuator" : element.name;
    std::vector<Attribute>& known = classes_[own].attributes[kind];
    known = merged(element.attributes, known, diagnostics_);
  }
  for (const Element& nested : section.children) {
    if (nested.name != "default") continue;
    const Attribute* name = find(nested, "class");
    if (name == nullptr || name->value.empty()) {
      diagnostics_.error("missing-attribute", nested.place, "a nested 'default' needs a name: class=\"...\"");
      continue;
    }
    const auto same =
        std::find_if(classes_.begin(), classes_.end(), [&](const Class& c) { return c.name == name->value; });
    if (same != classes_.end()) {
      Diagnostic& error = diagnostics_.error(
          "duplicate-class", name->place, fmt::format("default class '{}' is declared twice", name->value));
      if (same->place.source) error.notes.push_back({same->place, "first declared here"});
      continue;
    }
    classes_.push_back({name->value, name->place, classes_[own].attributes});
    read(nested, classes_.size() - 1);
  }
}

const Defaults::Class* Defaults::find_class(const Attribute& name) const {
  for (const Class& c : classes_)
    if (c.name == name.value) return &c;
  std::vector<std::string> names;
  for (const Class& c : classes_) names.push_back(c.name);
  diagnostics_.error("unknown-class", name.place, fmt::format("default class '{}' is not declared", name.value)).hint =
      did_you_mean(name.value, names);
  return nullptr;
}

Element Defaults::resolved(const Element& element, const Attribute* childclass, const std::string& kind) const {
  const Attribute* own = find(element, "class");
  const Attribute* asked = own != nullptr ? own : childclass;
  const Class* from = asked == nullptr ? &classes_.front() : find_class(*asked);
  Element result = element;
  if (from == nullptr) return result;
  const auto found = from->attributes.find(kind);
  if (found == from->attributes.end()) return result;
  result.attributes = merged(element.attributes, found->second, diagnostics_);
  return result;
}

}  // namespace robcogen::import::from_mjcf
