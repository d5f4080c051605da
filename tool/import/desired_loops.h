// Loops of desired-transforms documents.
#pragma once

#include "language/desired/document.h"

namespace robcogen::import {

// Returns the document with the body of each loop repeated for each of its instances, which replace the loop variable.
language::desired::Document unrolled(const language::desired::Document& document);

}  // namespace robcogen::import
