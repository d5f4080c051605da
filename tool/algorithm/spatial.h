// Vectors, plane rotations and symmetric matrices over symbolic scalars: the cheap forms that the algorithms are
// written in. Never a dense 6 x 6, never a dense 3 x 3 rotation.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "symbolic/expression.h"

namespace robcogen::algorithm {

using symbolic::Expression;
using symbolic::Graph;

struct Vector3 {
  std::array<Expression, 3> element;
  Expression& operator[](std::size_t i) { return element[i]; }
  const Expression& operator[](std::size_t i) const { return element[i]; }
};

struct Matrix3 {
  std::array<Vector3, 3> row;
  Vector3& operator[](std::size_t i) { return row[i]; }
  const Vector3& operator[](std::size_t i) const { return row[i]; }
};

// A spatial vector about a point: angular velocity or moment, and linear velocity or force.
struct Spatial {
  Vector3 angular;
  Vector3 linear;
};

Vector3 operator+(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a);
Vector3 operator*(const Expression& k, const Vector3& a);
Vector3& operator+=(Vector3& a, const Vector3& b);
Vector3& operator-=(Vector3& a, const Vector3& b);
Expression dot(const Vector3& a, const Vector3& b);
Vector3 cross(const Vector3& a, const Vector3& b);
Vector3 multiply(const Matrix3& m, const Vector3& v);
bool is_zero(const Vector3& v);

// [p]x with [p]x v = p x v.
Matrix3 skew(const Vector3& p);
Matrix3 operator+(const Matrix3& a, const Matrix3& b);

Spatial& operator+=(Spatial& a, const Spatial& b);
Spatial& operator-=(Spatial& a, const Spatial& b);
Expression dot(const Spatial& a, const Spatial& b);

// a b + c d, a b - c d. C++ leaves open which operand of an operator is made first, and the order of making decides how
// equal programs are spelled: these go from left to right with every compiler.
Expression sum_of_products(const Expression& a, const Expression& b, const Expression& c, const Expression& d);
Expression difference_of_products(const Expression& a, const Expression& b, const Expression& c, const Expression& d);

// Names the three components `<name>x`, `<name>y`, `<name>z`.
void name(Graph& graph, const Vector3& v, const std::string& name);

// Rotation by one angle about one coordinate axis: 4 multiplications and 2 additions a vector.
struct PlaneRotation {
  int axis = 2;           // 0, 1, 2
  Expression c;           // cosine
  Expression s;           // sine
  Expression angle = {};  // rad, where it matters
};

// A rotation by a multiple of 90 degrees: image[i] is the axis that row i picks, sign[i] its sign. (P v)_i =
// sign[i] v_image[i]. Free.
struct QuarterTurns {
  std::array<int, 3> image{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};
};
QuarterTurns quarter_turn(int axis, int turns);
QuarterTurns operator*(const QuarterTurns& a, const QuarterTurns& b);
QuarterTurns inverse(const QuarterTurns& q);

// R = quarter * planes[0] * planes[1] * …: coordinates in the rotated (child) frame to those in the parent frame.
struct Rotation {
  QuarterTurns quarter;
  std::vector<PlaneRotation> planes;
};

Vector3 to_parent(const Rotation& r, const Vector3& v);  // R v
Vector3 to_child(const Rotation& r, const Vector3& v);   // R' v
// R M R'. The symmetric form wants a symmetric matrix, both triangles of it, and returns one.
Matrix3 symmetric_to_parent(const Rotation& r, const Matrix3& m);
Matrix3 general_to_parent(const Rotation& r, const Matrix3& m);

}  // namespace robcogen::algorithm
