// Converts names of a document to identifiers of a model.
#pragma once

#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

struct Identifiers {
  std::string robot;
  std::vector<std::string> links;   // in the order of the document
  std::vector<std::string> joints;  // likewise; empty for joints that the model does not have
};

// Gives a joint with the name of a link the name `<name>_joint`, or `<name>_joint_2`, …, with a note. Reports two names
// of one kind that become equal, and names that are too long for a robot document.
Identifiers identifiers_of(const Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
