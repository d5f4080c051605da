// Prints a library as an ES module, for browsers and for Node.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::javascript {

// Prints <name>.mjs, where the enclosing namespaces precede the name, `a_b_hyl.mjs`: the constants of the robot, and
// its functions under the names that `eval` takes: `inverse_dynamics(…)`,
// `transforms.homogeneous.fr_base_X_fr_foot(q)`. Vectors are arrays of numbers, matrices are arrays of rows. Overloads
// are one function whose last arguments may be left out. A function throws a TypeError if an argument has another
// shape.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::javascript
