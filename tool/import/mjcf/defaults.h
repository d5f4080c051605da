// Default classes: attributes that elements have when they do not give them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "import/mjcf/element.h"

namespace robcogen::import::from_mjcf {

class Defaults {
 public:
  // Reads every `default` of the root element. Reports classes without a name, and names that are given twice.
  Defaults(const Element& root, Diagnostics& diagnostics);

  // Whether the class is declared. Reports it otherwise.
  bool knows(const Attribute& name) const { return find_class(name) != nullptr; }

  // The element with all attributes that it has: its own, then those of its attribute `class`, else of `childclass`;
  // without either, of the top-level class. Reports a `class` that is not declared.
  Element resolved(const Element& element, const Attribute* childclass) const;

 private:
  struct Class {
    std::string name;
    Place place;
    std::map<std::string, std::vector<Attribute>> attributes;  // by name of the element
  };

  void read(const Element& section, std::size_t own);
  const Class* find_class(const Attribute& name) const;

  std::vector<Class> classes_;  // [0] is the top-level class
  Diagnostics& diagnostics_;
};

}  // namespace robcogen::import::from_mjcf
