// Makes expressions short enough for their lines.
#pragma once

#include "backend/common/arrangement.h"

namespace robcogen::backend {

// Spells the expression of each statement. A subexpression that makes a line too long becomes a line of its own.
void fit_lines(Arrangement& arranged);

}  // namespace robcogen::backend
