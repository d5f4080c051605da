// How links and joints of a document hang together.
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

// Declares link `world`, without inertia, where joints refer to it as a parent and it would be the root: no joint has it
// as a child, and each declared link is the child of a joint. Warns of it. Other undeclared links stay errors.
void declare_world(Document& document, Diagnostics& diagnostics);

// Reports names given twice and names that nothing has, links with two parents, and what is no one tree. nullopt when
// an error was reported.
std::optional<Topology> connect(const Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
