// Principal moments of inertia.
#pragma once

#include <array>

#include "model/kinematic_tree.h"

namespace robcogen::model {

using SymmetricMatrix = std::array<std::array<double, 3>, 3>;

// Returns the tensor about the centre of mass, in the axes of `inertia.reference` or, without it, of the link frame.
SymmetricMatrix central_tensor(const Inertia& inertia);

// Returns the eigenvalues of an inertia tensor (kg m^2) in ascending order.
std::array<double, 3> principal_moments(SymmetricMatrix tensor);

}  // namespace robcogen::model
