#include "algorithm/spatial/spatial_inertia.h"

namespace robcogen::algorithm {
namespace {

// The inertia about a point displaced by -p: B' = B + [p]x M, A' = A - B' [p]x + [p]x B'.
SpatialInertia displaced(const SpatialInertia& x, const Vector3& p) {
  if (is_zero(p)) return x;
  const Matrix3 k = skew(p);
  SpatialInertia result = x;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) result.b[r][c] = x.b[r][c] + dot(k[r], x.m[c]);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = r; c < 3; ++c) {
      result.a[r][c] = x.a[r][c];
      result.a[r][c] += dot(k[c], r == c ? result.b[r] + x.b[r] : result.b[r]);
      if (r != c) result.a[r][c] += dot(k[r], x.b[c]);
      result.a[c][r] = result.a[r][c];
    }
  }
  return result;
}

}  // namespace

SpatialInertia rigid_body_inertia(const MassProperties& body) {
  SpatialInertia result{inertia_tensor(body), skew(body.first_moment), {}};
  for (std::size_t i = 0; i < 3; ++i) result.m[i][i] = body.mass;
  return result;
}

SpatialInertia operator+(const SpatialInertia& x, const SpatialInertia& y) {
  return {x.a + y.a, x.b + y.b, x.m + y.m};
}

SpatialInertia to_parent(const Pose& X_PC, const SpatialInertia& child) {
  const SpatialInertia slid = displaced(child, {Expression(), Expression(), X_PC.slide});
  return displaced(
      {symmetric_to_parent(X_PC.rotation, slid.a), general_to_parent(X_PC.rotation, slid.b),
       symmetric_to_parent(X_PC.rotation, slid.m)},
      X_PC.offset);
}

SquareMatrix matrix(const SpatialInertia& x) {
  SquareMatrix result(6);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = x.a[at(i)][at(j)];
      result(i, 3 + j) = result(3 + j, i) = x.b[at(i)][at(j)];
      result(3 + i, 3 + j) = x.m[at(i)][at(j)];
    }
  }
  return result;
}

}  // namespace robcogen::algorithm
