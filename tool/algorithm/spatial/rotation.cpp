#include "algorithm/spatial/rotation.h"

namespace robcogen::algorithm {
namespace {

Expression signed_by(int sign, const Expression& e) {
  return sign < 0 ? -e : e;
}

Vector3 rotate(const PlaneRotation& r, const Vector3& v, bool transposed) {
  if (r.matrix) return multiply(transposed ? algorithm::transposed(*r.matrix) : *r.matrix, v);
  const auto i = static_cast<std::size_t>((r.axis + 1) % 3), j = static_cast<std::size_t>((r.axis + 2) % 3);
  const Expression s = transposed ? -r.s : r.s;
  Vector3 result = v;
  result[i] = difference_of_products(r.c, v[i], s, v[j]);
  result[j] = sum_of_products(s, v[i], r.c, v[j]);
  return result;
}

// R m R' for a symmetric m. Because R is orthogonal, it is R (m - m_zz 1) R' + m_zz 1, which has one element less.
Matrix3 symmetric_product(const Matrix3& R, const Matrix3& m) {
  Matrix3 rest = m;
  for (std::size_t i = 0; i < 3; ++i) rest[i][i] = i == 2 ? Expression() : m[i][i] - m[2][2];
  const Matrix3 half = R * rest;
  Matrix3 result;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = r; c < 3; ++c) {
      result[r][c] = dot(half[r], R[c]);
      if (r == c) result[r][c] += m[2][2];
      result[c][r] = result[r][c];
    }
  return result;
}

// Conjugation by a plane rotation acts on the 2 x 2 block of its plane by double angles, on the rest as on vectors:
// with w = s^2, u = s c, e = xx - yy: k = e w + 2 u xy; xx' = xx - k; yy' = yy + k; xy' = xy (1 - 2 w) + e u.
Matrix3 conjugate_symmetric(const PlaneRotation& r, const Matrix3& m) {
  if (r.matrix) return symmetric_product(*r.matrix, m);
  const auto a = static_cast<std::size_t>(r.axis), i = (a + 1) % 3, j = (a + 2) % 3;
  Matrix3 result = m;
  const Expression e = m[i][i] - m[j][j];
  if (!e.is_zero() || !m[i][j].is_zero()) {
    const Expression w = r.s * r.s, u = r.s * r.c;
    const Expression twice = u + u, k = sum_of_products(e, w, m[i][j], twice);
    Graph& graph = *w.graph();
    result[i][i] = m[i][i] - k;
    result[j][j] = m[j][j] + k;
    const Expression cosine = graph.one() - (w + w);
    result[i][j] = sum_of_products(m[i][j], cosine, e, u);
    result[j][i] = result[i][j];
  }
  result[i][a] = difference_of_products(r.c, m[i][a], r.s, m[j][a]);
  result[j][a] = sum_of_products(r.s, m[i][a], r.c, m[j][a]);
  result[a][i] = result[i][a];
  result[a][j] = result[j][a];
  return result;
}

// The same for a general matrix, with e = xx - yy, f = xy + yx: k = e w + f u, l = e u - f w.
Matrix3 conjugate_general(const PlaneRotation& r, const Matrix3& m) {
  if (r.matrix) return *r.matrix * (m * transposed(*r.matrix));
  const auto a = static_cast<std::size_t>(r.axis), i = (a + 1) % 3, j = (a + 2) % 3;
  Matrix3 result = m;
  const Expression e = m[i][i] - m[j][j], f = m[i][j] + m[j][i];
  if (!e.is_zero() || !f.is_zero()) {
    const Expression w = r.s * r.s, u = r.s * r.c;
    const Expression k = sum_of_products(e, w, f, u), l = difference_of_products(e, u, f, w);
    result[i][i] = m[i][i] - k;
    result[j][j] = m[j][j] + k;
    result[i][j] = m[i][j] + l;
    result[j][i] = m[j][i] + l;
  }
  result[i][a] = difference_of_products(r.c, m[i][a], r.s, m[j][a]);
  result[j][a] = sum_of_products(r.s, m[i][a], r.c, m[j][a]);
  result[a][i] = difference_of_products(r.c, m[a][i], r.s, m[a][j]);
  result[a][j] = sum_of_products(r.s, m[a][i], r.c, m[a][j]);
  return result;
}

Vector3 turn(const QuarterTurns& q, const Vector3& v) {
  Vector3 result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = signed_by(q.sign[i], v[static_cast<std::size_t>(q.image[i])]);
  return result;
}

}  // namespace

PlaneRotation rotation_by_quaternion(Graph& graph, const std::array<Expression, 4>& q) {
  const auto& [w, a, b, c] = q;  // w + a i + b j + c k
  const Expression A = a + a, B = b + b, C = c + c;
  const Expression aA = a * A, bB = b * B, cC = c * C;
  const Expression aB = a * B, aC = a * C, bC = b * C;
  const Expression wA = w * A, wB = w * B, wC = w * C;
  const Expression one = graph.one();
  PlaneRotation rotation;
  rotation.axis = PlaneRotation::kAnyAxis;
  rotation.matrix = std::make_shared<const Matrix3>(Matrix3{
      {Vector3{one - (bB + cC), aB - wC, aC + wB}, Vector3{aB + wC, one - (aA + cC), bC - wA},
       Vector3{aC - wB, bC + wA, one - (aA + bB)}}});
  return rotation;
}

Matrix3 conjugate(const QuarterTurns& q, const Matrix3& m) {
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result[i][j] = signed_by(
          q.sign[i] * q.sign[j], m[static_cast<std::size_t>(q.image[i])][static_cast<std::size_t>(q.image[j])]);
  return result;
}

QuarterTurns quarter_turn(int axis, int turns) {
  QuarterTurns one;
  const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
  one.image[i] = static_cast<int>(j);  // R(90): (v_i, v_j) -> (-v_j, v_i)
  one.sign[i] = -1;
  one.image[j] = static_cast<int>(i);
  QuarterTurns result;
  for (int k = ((turns % 4) + 4) % 4; k > 0; --k) result = result * one;
  return result;
}

QuarterTurns operator*(const QuarterTurns& a, const QuarterTurns& b) {
  QuarterTurns result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto middle = static_cast<std::size_t>(a.image[i]);
    result.image[i] = b.image[middle];
    result.sign[i] = a.sign[i] * b.sign[middle];
  }
  return result;
}

QuarterTurns inverse(const QuarterTurns& q) {
  QuarterTurns result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.image[static_cast<std::size_t>(q.image[i])] = static_cast<int>(i);
    result.sign[static_cast<std::size_t>(q.image[i])] = q.sign[i];
  }
  return result;
}

Vector3 to_parent(const Rotation& r, const Vector3& v) {
  Vector3 result = v;
  for (auto plane = r.planes.rbegin(); plane != r.planes.rend(); ++plane) result = rotate(*plane, result, false);
  return turn(r.quarter, result);
}

Vector3 to_child(const Rotation& r, const Vector3& v) {
  Vector3 result = turn(inverse(r.quarter), v);
  for (const PlaneRotation& plane : r.planes) result = rotate(plane, result, true);
  return result;
}

Matrix3 symmetric_to_parent(const Rotation& r, const Matrix3& m) {
  Matrix3 result = m;
  for (auto plane = r.planes.rbegin(); plane != r.planes.rend(); ++plane) result = conjugate_symmetric(*plane, result);
  return conjugate(r.quarter, result);
}

Matrix3 general_to_parent(const Rotation& r, const Matrix3& m) {
  Matrix3 result = m;
  for (auto plane = r.planes.rbegin(); plane != r.planes.rend(); ++plane) result = conjugate_general(*plane, result);
  return conjugate(r.quarter, result);
}

}  // namespace robcogen::algorithm
