#include "algorithm/spatial/triangle.h"

namespace robcogen::algorithm {

using symbolic::Expression;

Vector2 operator+(const Vector2& a, const Vector2& b) {
  return {a.x + b.x, a.y + b.y};
}

Vector2 operator-(const Vector2& a, const Vector2& b) {
  return {a.x - b.x, a.y - b.y};
}

Vector2 operator-(const Vector2& a) {
  return {-a.x, -a.y};
}

Vector2 operator*(const Expression& k, const Vector2& a) {
  return {k * a.x, k * a.y};
}

Expression dot(const Vector2& a, const Vector2& b) {
  const Expression x = a.x * b.x, y = a.y * b.y;
  return x + y;
}

Expression cross(const Vector2& a, const Vector2& b) {
  const Expression xy = a.x * b.y, yx = a.y * b.x;
  return xy - yx;
}

Vector2 perpendicular(const Vector2& a) {
  return {-a.y, a.x};
}

Vector2 turned(const Vector2& turn, const Vector2& v) {
  const Expression cx = turn.x * v.x, sy = turn.y * v.y, sx = turn.y * v.x, cy = turn.x * v.y;
  return {cx - sy, sx + cy};
}

Vector2 turned_back(const Vector2& turn, const Vector2& v) {
  return turned({turn.x, -turn.y}, v);
}

namespace {

// The turn between two vectors, given the reciprocal of the square of their length.
Vector2 turn_between(const Vector2& from, const Vector2& to, const Expression& reciprocal) {
  // If a side is constant, so are these quotients.
  const Vector2 scaled = reciprocal * from;
  const Expression c = dot(scaled, to), s = cross(scaled, to);
  return {c, s};
}

Expression one(const Expression& e) {
  return e.graph()->one();
}

Expression signed_root(const Expression& square, double branch) {
  const Expression root = sqrt(square);
  return branch < 0.0 ? -root : root;
}

}  // namespace

Vector2 turn_between(const Vector2& from, const Vector2& to) {
  const Expression square = dot(from, from);
  return turn_between(from, to, one(square) / square);
}

namespace {

// The vertex of a triangle on the side `base`, from the squares of the sides that meet the base at its beginning and at
// its end. With p D = (D^2 + a^2 - b^2) / 2 = k and D x p = h, h^2 = a^2 D^2 - k^2.
Vector2 vertex(const Expression& aa, const Expression& bb, const Vector2& base, double branch) {
  const Expression dd = dot(base, base);
  const Expression difference = aa - bb;
  const Expression k = 0.5 * (dd + difference);
  const Expression reciprocal = one(dd) / dd;
  const Expression product = aa * dd, square = k * k;
  const Expression h = signed_root(product - square, branch);
  const Vector2 along = k * base, across = h * perpendicular(base);
  return reciprocal * (along + across);
}

}  // namespace

std::pair<Vector2, Vector2> triangle(const Vector2& a, const Vector2& b, const Vector2& base, double branch) {
  const Expression aa = dot(a, a), bb = dot(b, b);
  const Vector2 p = vertex(aa, bb, base, branch);
  const Vector2 rest = base - p;
  return {turn_between(a, p, one(aa) / aa), turn_between(b, rest, one(bb) / bb)};
}

Vector2 turn_to_distance(const Vector2& side, const Vector2& base, const Expression& squared_distance, double branch) {
  const Expression aa = dot(side, side);
  return turn_between(side, vertex(aa, squared_distance, base, branch), one(aa) / aa);
}

// With n = direction x through: the point is at h along the direction and at n across it.
OnLine on_line(const Vector2& a, const Vector2& through, const Vector2& direction, double branch) {
  const Expression m = dot(direction, through), n = cross(direction, through);
  const Expression square = dot(a, a), across = n * n;
  const Expression h = signed_root(square - across, branch);
  const Vector2 along = h * direction, aside = n * perpendicular(direction);
  return {along + aside, h - m};
}

}  // namespace robcogen::algorithm
