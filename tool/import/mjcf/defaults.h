// Default classes: the attributes of elements that do not give them themselves.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "import/mjcf/element.h"

namespace robcogen::import::from_mjcf {

// The elements of `actuator`, which share one class "actuator" of defaults.
const std::vector<std::string>& actuator_names();
bool is_actuator(const std::string& element);

class Defaults {
 public:
  // Reads every `default` of the root element. Reports classes without a name, names that are given twice, a second
  // name of the top-level class, and a `quat` that has no effect.
  Defaults(const Element& root, Diagnostics& diagnostics);

  // Whether the class is declared. Reports an undeclared class.
  bool knows(const Attribute& name) const { return find_class(name) != nullptr; }

  // Returns the element with all attributes that apply to it: its own, then those of its `class`, or else of
  // `childclass`, or else of the top-level class. Reports an undeclared `class`, and a `quat` that has no effect.
  Element resolved(const Element& element, const Attribute* childclass) const {
    return resolved(element, childclass, element.name);
  }
  // The same for an element whose defaults are those of the elements named `kind`.
  Element resolved(const Element& element, const Attribute* childclass, const std::string& kind) const;

 private:
  struct Class {
    std::string name;
    Place place;
    std::map<std::string, std::vector<Attribute>> attributes;  // by name of the element
  };

  void rename_top(const Attribute& name);
  void read(const Element& section, std::size_t own);
  const Class* find_class(const Attribute& name) const;

  std::vector<Class> classes_;  // [0] is the top-level class
  Diagnostics& diagnostics_;
};

}  // namespace robcogen::import::from_mjcf
