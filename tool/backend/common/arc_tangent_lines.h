// Arc tangents that are computed together, because lanes take hardly longer than one of them.
#pragma once

#include "backend/common/lower.h"

namespace robcogen::backend {

// Stores of arc tangents in neighbouring elements of an output become one line, where Dialect::arc_tangents_together
// asks for it.
Kernel with_arc_tangents_together(Kernel kernel, const Dialect& dialect);

}  // namespace robcogen::backend
