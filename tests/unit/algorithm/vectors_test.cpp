// Vectors and matrices, motions and forces, compared with Eigen.
#include "algorithm/spatial/motion_force.h"

#include "values.h"

namespace robcogen::algorithm::vectors_test {
namespace {

using test::kTolerance;
using test::Numbers;

TEST(Vectors, Algebra) {
  Numbers n;
  const Vector3 a = n.vector(), b = n.vector();
  const Matrix3 m = n.matrix(), k = n.matrix();
  const Eigen::Vector3d va = n.value(a), vb = n.value(b);
  const Eigen::Matrix3d vm = n.value(m), vk = n.value(k);
  EXPECT_TRUE(n.value(a + b).isApprox(va + vb, kTolerance));
  EXPECT_TRUE(n.value(a - b).isApprox(va - vb, kTolerance));
  EXPECT_TRUE(n.value(-a).isApprox(-va, kTolerance));
  EXPECT_TRUE(n.value(a[0] * b).isApprox(va[0] * vb, kTolerance));
  EXPECT_NEAR(n.value(dot(a, b)), va.dot(vb), kTolerance);
  EXPECT_TRUE(n.value(cross(a, b)).isApprox(va.cross(vb), kTolerance));
  EXPECT_TRUE(n.value(multiply(m, a)).isApprox(vm * va, kTolerance));
  EXPECT_TRUE(n.value(multiply(skew(a), b)).isApprox(va.cross(vb), kTolerance));
  EXPECT_TRUE(n.value(m + k).isApprox(vm + vk, kTolerance));
  EXPECT_TRUE(is_zero(Vector3()));
  EXPECT_FALSE(is_zero(Vector3{Expression(), Expression(), a[2]}));
}

TEST(Vectors, MotionsAndForces) {
  Numbers n;
  const Vector3 a = n.vector(), b = n.vector();
  const Eigen::Vector3d va = n.value(a), vb = n.value(b);
  EXPECT_NEAR(n.value(dot(Force{a, b}, Motion{b, a})), 2 * va.dot(vb), kTolerance);
  Force force{a, b};
  force += Force{b, b};
  force -= Force{a, a};
  EXPECT_TRUE(n.value(force.moment).isApprox(vb, kTolerance));
  EXPECT_TRUE(n.value(force.linear).isApprox(2 * vb - va, kTolerance));
  Motion motion = a[0] * Motion{a, b};
  motion += Motion{a, b};
  EXPECT_TRUE(n.value(motion.angular).isApprox((1 + va[0]) * va, kTolerance));
  EXPECT_TRUE(n.value(motion.linear).isApprox((1 + va[0]) * vb, kTolerance));
}

}  // namespace
}  // namespace robcogen::algorithm::vectors_test
