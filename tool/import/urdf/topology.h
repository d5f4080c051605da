// The tree of links and joints of a document.
#pragma once

#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

struct Topology {
  int root = -1;                  // link
  std::vector<int> parent_joint;  // by link; -1 for the root
  std::vector<int> parent;        // link, by joint
  std::vector<int> child;         // link, by joint
  std::vector<int> order;         // links, parents before children
};

// Declares link `world` without inertia if joints refer to it as a parent and it can be the root: no joint has it as a
// child, and each declared link is the child of a joint. Warns about it. Other undeclared links are errors.
void declare_world(Document& document, Diagnostics& diagnostics);

// Reports names that are duplicate or unknown, links with two parents, and links that do not form one tree. nullopt if
// an error was reported.
std::optional<Topology> connect(const Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
