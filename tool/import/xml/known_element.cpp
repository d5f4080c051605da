#include "import/xml/known_element.h"

#include <fmt/format.h>

#include "support/words.h"

namespace robcogen::import::xml {

namespace {

std::vector<std::string> joined(std::vector<std::string> names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

}  // namespace

bool KnownElement::has_attribute(const std::string& name) const {
  return is_among(attributes, name) || is_among(attributes_without_effect, name);
}

const KnownElement* find(const KnownElements& elements, const std::string& kind) {
  const auto found = elements.find(kind);
  return found == elements.end() ? nullptr : &found->second;
}

Finding unknown_attribute(const LocatedAttribute& attribute, const std::string& owner, const KnownElement& known) {
  return {
      "unknown-attribute", fmt::format("attribute '{}' of this '{}' is unknown and ignored", attribute.name, owner),
      did_you_mean(attribute.name, joined(known.attributes, known.attributes_without_effect)), attribute.name_place};
}

Finding unknown_element(const LocatedElement& child, const std::string& owner, const KnownElement& known) {
  return {
      "unknown-element", fmt::format("element '{}' of this '{}' is unknown and ignored", child.name, owner),
      did_you_mean(child.name, joined(known.children, known.children_without_effect)), child.place};
}

}  // namespace robcogen::import::xml
