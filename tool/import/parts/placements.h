// Placements as expressions: one after the other, and their mirror images. A parameter stays one.
#pragma once

#include <array>

#include "import/parts/terms.h"
#include "language/kinematics/document.h"

namespace robcogen::import::parts {

using language::kinematics::Placement;
using language::kinematics::Vector;

// A diagonal matrix of signs, by its diagonal.
using Signs = std::array<int, 3>;
inline constexpr Signs kNoSigns = {1, 1, 1};

// Reverses one axis: a mirror image.
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

// The pose of C in A from those of B in A and of C in B. nullopt where the product of both rotations has no angles that
// are expressions: a parameter among them, and axes that do not follow one another.
std::optional<Placement> composed(const Placement& a_b, const Placement& b_c);

// The mirror image P X C of the pose X: of the parent's axes by P, of its own by C, both reflections, or both none.
Placement mirrored(const Placement& placement, const Signs& parent, const Signs& child);

// The axis to reverse in a frame so that its mirror image is turned least, when `parent` is reversed in the axes of its
// link.
Signs nearest_image(const Placement& placement, const Signs& parent);

}  // namespace robcogen::import::parts
