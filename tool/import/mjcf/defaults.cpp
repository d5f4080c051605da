#include "import/mjcf/defaults.h"

#include <fmt/format.h>

#include <algorithm>

namespace robcogen::import::from_mjcf {

namespace {

// The attributes of `own`, then those of `inherited` that `own` does not have.
std::vector<Attribute> merged(std::vector<Attribute> own, const std::vector<Attribute>& inherited) {
  const std::size_t count = own.size();
  for (const Attribute& a : inherited) {
    const auto end = own.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::none_of(own.begin(), end, [&](const Attribute& other) { return other.name == a.name; })) own.push_back(a);
  }
  return own;
}

}  // namespace

Defaults::Defaults(const Element& root, Diagnostics& diagnostics) : diagnostics_(diagnostics) {
  classes_.push_back({"main", {}, {}});
  for (const Element& section : root.children) {
    if (section.name != "default") continue;
    if (const Attribute* name = find(section, "class")) classes_[0].name = name->value;
    read(section, 0);
  }
}

// A nested class starts with all attributes of the enclosing class, including those that stand after it.
void Defaults::read(const Element& section, std::size_t own) {
  for (const Element& element : section.children) {
    if (element.name == "default") continue;
    std::vector<Attribute>& known = classes_[own].attributes[element.name];
    known = merged(element.attributes, known);
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
  std::vector<Attribute> inherited = found->second;
  // An element gives its orientation in one way only.
  if (has_orientation(element)) std::erase_if(inherited, [](const Attribute& a) { return is_orientation(a); });
  result.attributes = merged(result.attributes, inherited);
  return result;
}

}  // namespace robcogen::import::from_mjcf
