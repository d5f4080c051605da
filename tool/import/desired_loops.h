// Loops of desired-transforms documents.
#pragma once

#include "language/desired/document.h"

namespace robcogen::import {

// The document with the body of each loop once for each of its instances, which stand in place of the variable.
language::desired::Document unrolled(const language::desired::Document& document);

}  // namespace robcogen::import
