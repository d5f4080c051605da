// Converts the tree of bodies to the description of a model.
#pragma once

#include "import/mjcf/document.h"

namespace robcogen::import::from_mjcf {

// Identifiers for all names, including names for unnamed elements.
struct Identifiers {
  std::string robot;
  std::vector<std::string> bodies;
  std::vector<std::vector<std::string>> joints;  // by body
  std::vector<std::vector<std::string>> sites;   // by body
};

// Bodies and joints get different names, and so do bodies and sites: a joint or site with the name of a body gets the
// suffix of its kind. Reports names that are given twice or too long. One note lists the names that were changed.
Identifiers identifiers_of(const Document& document, Diagnostics& diagnostics);

// - The base is the floating body of the robot, or the world.
// - A body without joints is part of its parent.
// - The joints of a body form a chain of massless links: MuJoCo applies them one after the other, each in the frame
//   that the joints before it have moved.
// Reports couplings between the robot and other bodies. A note counts the bodies and sites that are not part of it.
model::Description describe(const Document& document, const Identifiers& identifiers, Diagnostics& diagnostics);

// The names of bodies whose pairs are not checked: those that the document excludes, and those no geoms of which may
// meet.
std::vector<std::array<std::string, 2>> excluded_pairs(const Document& document, const Identifiers& identifiers);

}  // namespace robcogen::import::from_mjcf
