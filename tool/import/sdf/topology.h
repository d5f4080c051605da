// How the joints of a document connect its links.
#pragma once

#include "import/sdf/document.h"

namespace robcogen::import::from_sdf {

struct Topology {
  int root = kWorldLink;          // link; the world if a joint leads to it, or if the model is static
  std::vector<int> parent_joint;  // by link; -1 for the root, and for links that are fixed in a static model
  std::vector<int> order;         // links, parents first
  std::vector<int> loops;         // joints that close loops
};

// Reports joints from a link to itself, and links that no joint connects to the others. nullopt if an error was
// reported.
std::optional<Topology> connect(const Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_sdf
