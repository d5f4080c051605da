// The runtime's 6D types and gravity.
#include "robcogen/spatial.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "robcogen/link_wrenches.h"

namespace robcogen::spatial_test {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

const Vector6 kVector = (Vector6() << 1, 2, 3, 4, 5, 6).finished();

TEST(Spatial, AngularFirst) {
  const Twist v(kVector);
  EXPECT_EQ(v.angular(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(v.linear(), Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(v.vector(), kVector);
  EXPECT_EQ(v.data()[4], 5);
  EXPECT_EQ(Twist(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6)), v);
}

TEST(Spatial, DefaultIsZero) {
  EXPECT_EQ(Wrench().vector(), Vector6::Zero());
  EXPECT_EQ(BasicTwist<float>().angular(), Eigen::Vector3f::Zero());
}

TEST(Spatial, PartsOfAVariableCanBeWritten) {
  Wrench w;
  w.linear() = Eigen::Vector3d(7, 8, 9);
  w.angular().x() = 1;
  EXPECT_EQ(w, Wrench((Vector6() << 1, 0, 0, 7, 8, 9).finished()));
}

TEST(Spatial, PartsOfATemporaryAreCopies) {
  static_assert(std::is_same_v<decltype(Wrench().linear()), Eigen::Vector3d>);
  const auto f = Wrench(kVector).linear();
  EXPECT_EQ(f, Eigen::Vector3d(4, 5, 6));
}

TEST(Spatial, VectorsOfOneKindAddAndScale) {
  const Twist v(kVector);
  EXPECT_EQ((v + v).vector(), 2 * kVector);
  EXPECT_EQ((v - 0.5 * v).vector(), 0.5 * kVector);
  EXPECT_EQ((-v * 2.0).vector(), -2 * kVector);
  EXPECT_NE(v, -v);
}

template <class A, class B>
constexpr bool kAdds = requires(A a, B b) {
  a + b;
};

TEST(Spatial, KindsDoNotMix) {
  EXPECT_TRUE((kAdds<Twist, Twist>));
  EXPECT_FALSE((kAdds<Twist, SpatialAcceleration>));
  EXPECT_FALSE((kAdds<Wrench, Twist>));
  EXPECT_FALSE((std::is_convertible_v<Twist, SpatialAcceleration>));
  EXPECT_FALSE((std::is_constructible_v<Twist, Wrench>));
  EXPECT_FALSE((std::is_convertible_v<Vector6, Twist>));
  EXPECT_FALSE((std::is_convertible_v<Twist, Vector6>));
  EXPECT_FALSE((std::is_convertible_v<Eigen::Vector3d, Gravity>));
}

// The types are safe in containers and as arguments by value, whatever vector registers the machine has.
TEST(Spatial, NoAlignmentBeyondTheScalars) {
  EXPECT_EQ(alignof(Twist), alignof(double));
  EXPECT_EQ(sizeof(Twist), 6 * sizeof(double));
  EXPECT_EQ(sizeof(BasicWrench<float>), 6 * sizeof(float));
  EXPECT_EQ(alignof(Gravity), alignof(double));
  EXPECT_TRUE(std::is_trivially_copyable_v<Twist>);
}

TEST(Gravity, StandardPointsDown) {
  static_assert(kStandardGravity.data()[2] == -9.81);
  EXPECT_EQ(kStandardGravity.vector(), Eigen::Vector3d(0, 0, -9.81));
  EXPECT_EQ(BasicGravity<float>::standard().data()[2], -9.81f);
  EXPECT_EQ(Gravity(Eigen::Vector3d(1, 2, 3)).vector(), Eigen::Vector3d(1, 2, 3));
}

TEST(LinkWrenches, StandLinkByLinkAndStartAtZero) {
  enum class Link { base, leg };
  LinkWrenches<double, Link, 2> external;
  for (int k = 0; k < 12; ++k) EXPECT_EQ(external.data()[k], 0);
  external[Link::leg] = Wrench(kVector);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(external.data()[6 + k], k + 1);
  EXPECT_EQ(external[1], Wrench(kVector));
}

}  // namespace
}  // namespace robcogen::spatial_test
