// Principal moments of inertia.
#pragma once

#include <array>

namespace robcogen::model {

using SymmetricMatrix = std::array<std::array<double, 3>, 3>;

// Returns the eigenvalues of an inertia tensor (kg m^2) in ascending order.
std::array<double, 3> principal_moments(SymmetricMatrix tensor);

}  // namespace robcogen::model
