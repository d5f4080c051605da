// Identifiers of the model for the names in a document.
#pragma once

#include "import/sdf/topology.h"

namespace robcogen::import::from_sdf {

struct Identifiers {
  std::string robot;
  std::string world;                             // the base, if that is the world
  std::vector<std::string> links;                // by link
  std::vector<std::vector<std::string>> joints;  // by joint: one for each coordinate; none for fixed joints of the tree
  std::vector<std::string> between;              // by joint: of the link between two axes
  std::vector<std::string> frames;               // by frame; empty unless it is declared
};

// Links and joints get different names, and so do links and declared frames: a joint or a frame with the name of a link
// gets the suffix of its kind. One note lists the names that were changed.
Identifiers identifiers_of(const Document& document, const Topology& topology, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_sdf
