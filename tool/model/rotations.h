// Rotations and placements of quantities: products, and the angles of a rotation.
#pragma once

#include <array>
#include <optional>

#include "model/placement.h"

namespace robcogen::model {

using RotationMatrix = std::array<std::array<Quantity, 3>, 3>;  // rows

RotationMatrix product(const RotationMatrix& a, const RotationMatrix& b);
RotationMatrix transposed(const RotationMatrix& m);
std::array<Quantity, 3> product(const RotationMatrix& m, const std::array<Quantity, 3>& v);

// Returns the angles of R = Rx Ry Rz, for a matrix of constants. Multiples of PI/4 are exact. Where Rx and Rz turn
// about the same axis, Rz is the identity.
std::array<Quantity, 3> angles_of(const RotationMatrix& R);

// Returns the angles of the rotation of `first` followed by that of `second`, as in Placement. nullopt if parameters do
// not allow this: the angles of a product of rotations are sums of their angles in special cases only.
std::optional<std::array<Quantity, 3>> turned_by(
    const std::array<Quantity, 3>& first,
    const std::array<Quantity, 3>& second);

// Returns the pose of a frame that is placed by `inner` in a frame that is placed by `outer`. nullopt like turned_by.
std::optional<Placement> placed_in(const Placement& outer, const Placement& inner);

}  // namespace robcogen::model
