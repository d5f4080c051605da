// From the tree of bodies to the description of a model.
#pragma once

#include "import/mjcf/document.h"

namespace robcogen::import::from_mjcf {

// Identifiers in the place of names, and names for what has none.
struct Identifiers {
  std::string robot;
  std::vector<std::string> bodies;
  std::vector<std::vector<std::string>> joints;  // by body
  std::vector<std::vector<std::string>> sites;   // by body
};

// Bodies and joints have different names, and so have bodies and sites: one that has the name of a body gets the suffix
// of its kind. Reports names that are given twice, and names that are too long; one note lists those that were changed.
Identifiers identifiers_of(const Document& document, Diagnostics& diagnostics);

// - The base is the body with the free joint; without one, the world.
// - A body without joints is part of its parent.
// - The joints of a body form a chain of links without mass: MuJoCo applies them one after the other, each in the frame
//   that those before it have moved.
// Reports bodies that move, but are not part of the robot that floats.
model::Description describe(const Document& document, const Identifiers& identifiers, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
