// Placements as expressions: their composition, and their mirror images. Parameters stay symbolic.
#pragma once

#include <array>

#include "import/parts/terms.h"
#include "language/kinematics/document.h"

namespace robcogen::import::parts {

using language::kinematics::Placement;
using language::kinematics::Vector;

// A diagonal matrix of signs, given by its diagonal.
using Signs = std::array<int, 3>;
inline constexpr Signs kNoSigns = {1, 1, 1};

// A reflection, which reverses one axis.
constexpr Signs reversed(int axis) {
  Signs signs = kNoSigns;
  signs[static_cast<std::size_t>(axis)] = -1;
  return signs;
}

Placement identity(Span span);
bool is_identity(const Placement& placement);

using Matrix = std::array<Vector, 3>;  // row by row

// R = Rx Ry Rz.
Matrix rotation_matrix(const Vector& angles);
Matrix product(const Matrix& a, const Matrix& b);
Matrix transposed(const Matrix& m);
Vector product(const Matrix& m, const Vector& v);
Vector sum(const Vector& a, const Vector& b);
Vector with_signs(const Signs& signs, const Vector& v);

// Returns the pose of C in A, given the poses of B in A and of C in B. nullopt if the product of the two rotations has
// no angles that are expressions: it depends on a parameter, and the axes of the rotations are not in sequence.
std::optional<Placement> composed(const Placement& a_b, const Placement& b_c);

// Returns the mirror image P X C of the pose X: P acts on the axes of the parent, C on the axes of the frame itself.
// Either both are reflections, or neither is.
Placement mirrored(const Placement& placement, const Signs& parent, const Signs& child);

// Returns the axis to reverse in a frame so that its mirror image is rotated least, if `parent` is reversed in the axes
// of its link.
Signs nearest_image(const Placement& placement, const Signs& parent);

}  // namespace robcogen::import::parts
