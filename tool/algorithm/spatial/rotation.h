// Rotations as products of quarter turns and plane rotations: the cheap form in which the recursions rotate vectors,
// never a dense 3 x 3 matrix.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "algorithm/spatial/vectors.h"

namespace robcogen::algorithm {

// A rotation by one angle about one coordinate axis (4 multiplications and 2 additions for a vector), or any rotation
// as a matrix (9 and 6).
struct PlaneRotation {
  int axis = 2;                                // 0, 1, 2; kAnyAxis with a matrix
  Expression c;                                // cosine
  Expression s;                                // sine
  Expression angle = {};                       // rad, where it matters
  std::shared_ptr<const Matrix3> matrix = {};  // in place of the others
  static constexpr int kAnyAxis = -1;
};

// The rotation of the unit quaternion w, x, y, z: the matrix is quadratic in its elements (Featherstone 2008, eq.
// 4.12).
PlaneRotation rotation_by_quaternion(Graph& graph, const std::array<Expression, 4>& q);

// A rotation by a multiple of 90 degrees: image[i] is the axis that row i picks, sign[i] its sign. (P v)_i = sign[i]
// v_image[i]. It costs nothing.
struct QuarterTurns {
  std::array<int, 3> image{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};
};
QuarterTurns quarter_turn(int axis, int turns);
QuarterTurns operator*(const QuarterTurns& a, const QuarterTurns& b);
QuarterTurns inverse(const QuarterTurns& q);
// Q m Q'.
Matrix3 conjugate(const QuarterTurns& q, const Matrix3& m);

// R = quarter * planes[0] * planes[1] * …: coordinates in the rotated (child) frame to those in the parent frame.
struct Rotation {
  QuarterTurns quarter;
  std::vector<PlaneRotation> planes;
};

Vector3 to_parent(const Rotation& r, const Vector3& v);  // R v
Vector3 to_child(const Rotation& r, const Vector3& v);   // R' v
// R M R'. The symmetric form takes a symmetric matrix with both triangles, and returns one.
Matrix3 symmetric_to_parent(const Rotation& r, const Matrix3& m);
Matrix3 general_to_parent(const Rotation& r, const Matrix3& m);

}  // namespace robcogen::algorithm
