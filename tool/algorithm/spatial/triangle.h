// Triangles and other plane geometry for the closures of loops.
#pragma once

#include <utility>

#include "symbolic/expression.h"

namespace robcogen::algorithm {

// A vector in a plane; also a turn, as its cosine and its sine.
struct Vector2 {
  symbolic::Expression x, y;
};

Vector2 operator+(const Vector2& a, const Vector2& b);
Vector2 operator-(const Vector2& a, const Vector2& b);
Vector2 operator-(const Vector2& a);
Vector2 operator*(const symbolic::Expression& k, const Vector2& a);
symbolic::Expression dot(const Vector2& a, const Vector2& b);
symbolic::Expression cross(const Vector2& a, const Vector2& b);
// The vector a quarter turn further.
Vector2 perpendicular(const Vector2& a);
// v turned, and turned back. For two turns: their sum, and their difference.
Vector2 turned(const Vector2& turn, const Vector2& v);
Vector2 turned_back(const Vector2& turn, const Vector2& v);
// The turn that takes `from` to `to`, two vectors of one length.
Vector2 turn_between(const Vector2& from, const Vector2& to);

// The sides a and b, turned so that they add up to the side `base`. `branch` is the side of the base on which their
// common vertex is: 1 to the left, -1 to the right.
std::pair<Vector2, Vector2> triangle(const Vector2& a, const Vector2& b, const Vector2& base, double branch);

// The turn of the vector `side` after which its end has this squared distance from the end of `base`; `branch` as
// above.
Vector2 turn_to_distance(
    const Vector2& side,
    const Vector2& base,
    const symbolic::Expression& squared_distance,
    double branch);

// The point at distance |a| from the origin on the line through `through` in the direction of the unit vector
// `direction`, and how far it is beyond `through`. `branch`: whether it is ahead of the foot of the perpendicular.
struct OnLine {
  Vector2 point;
  symbolic::Expression beyond;
};
OnLine on_line(const Vector2& a, const Vector2& through, const Vector2& direction, double branch);

}  // namespace robcogen::algorithm
