// What a language says about its elements, and findings about what a file says beyond it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "import/xml/findings.h"
#include "import/xml/located.h"

namespace robcogen::import::xml {

struct KnownElement {
  std::vector<std::string> attributes;                 // that are read, or reported where they have an effect
  std::vector<std::string> attributes_without_effect;  // that change neither kinematics nor dynamics
  std::vector<std::string> children;                   // elements in it that are read
  std::vector<std::string> children_without_effect;

  bool has_attribute(const std::string& name) const;
};

// By kind, which is the name of an element or, where its content depends on where it is, a path such as
// `inertial/pose`.
using KnownElements = std::map<std::string, KnownElement>;

// Returns nullptr for a kind that is not known.
const KnownElement* find(const KnownElements& elements, const std::string& kind);

// Warnings about an attribute, and about an element, that an element called `owner` does not have.
Finding unknown_attribute(const LocatedAttribute& attribute, const std::string& owner, const KnownElement& known);
Finding unknown_element(const LocatedElement& child, const std::string& owner, const KnownElement& known);

}  // namespace robcogen::import::xml
