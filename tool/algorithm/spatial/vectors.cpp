#include "algorithm/spatial/vectors.h"

namespace robcogen::algorithm {

Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector3 operator-(const Vector3& a) {
  return {-a[0], -a[1], -a[2]};
}
Vector3 operator*(const Expression& k, const Vector3& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
Vector3& operator+=(Vector3& a, const Vector3& b) {
  return a = a + b;
}
Vector3& operator-=(Vector3& a, const Vector3& b) {
  return a = a - b;
}
Expression dot(const Vector3& a, const Vector3& b) {
  const Expression two = sum_of_products(a[0], b[0], a[1], b[1]);
  return two + a[2] * b[2];
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {
      difference_of_products(a[1], b[2], a[2], b[1]), difference_of_products(a[2], b[0], a[0], b[2]),
      difference_of_products(a[0], b[1], a[1], b[0])};
}

Vector3 multiply(const Matrix3& m, const Vector3& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

bool is_zero(const Vector3& v) {
  return v[0].is_zero() && v[1].is_zero() && v[2].is_zero();
}

Matrix3 skew(const Vector3& p) {
  const Expression zero;
  return {{Vector3{zero, -p[2], p[1]}, Vector3{p[2], zero, -p[0]}, Vector3{-p[1], p[0], zero}}};
}

Expression sum_of_products(const Expression& a, const Expression& b, const Expression& c, const Expression& d) {
  const Expression first = a * b;
  return first + c * d;
}

Expression difference_of_products(const Expression& a, const Expression& b, const Expression& c, const Expression& d) {
  const Expression first = a * b;
  return first - c * d;
}

Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
  const Matrix3 columns = transposed(b);
  Matrix3 m;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) m[r][c] = dot(a[r], columns[c]);
  return m;
}

Matrix3 transposed(const Matrix3& m) {
  return {{Vector3{m[0][0], m[1][0], m[2][0]}, Vector3{m[0][1], m[1][1], m[2][1]}, Vector3{m[0][2], m[1][2], m[2][2]}}};
}

Matrix3 operator+(const Matrix3& a, const Matrix3& b) {
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}

Vector3 unit_vector(Graph& graph, std::size_t axis) {
  Vector3 v;
  v[axis] = graph.one();
  return v;
}

}  // namespace robcogen::algorithm
