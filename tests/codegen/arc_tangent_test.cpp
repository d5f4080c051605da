// Angles of sines and cosines, for numbers and in lanes, compared with those in long double.
#include "robcogen/arc_tangent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace robcogen {
namespace {

constexpr double kLargestError = 2;  // ulp

template <class Scalar>
double error_in_ulp(Scalar found, Scalar sine, Scalar cosine) {
  const long double exact = std::atan2(static_cast<long double>(sine), static_cast<long double>(cosine));
  const auto size = static_cast<Scalar>(std::abs(exact));
  const Scalar ulp = std::nextafter(size, std::numeric_limits<Scalar>::infinity()) - size;
  return static_cast<double>(std::abs(static_cast<long double>(found) - exact) / static_cast<long double>(ulp));
}

template <class Scalar>
class ArcTangent : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(ArcTangent, Scalars);

// Vectors of all directions and lengths, also along and next to the axes and their bisectors.
template <class Scalar>
class Vectors {
 public:
  struct Vector {
    Scalar sine, cosine;
  };
  Vector next() {
    const double length = std::pow(10.0, between(-3, 3));
    const double near = std::pow(10.0, between(-12, 0)) * between(-1, 1);
    const double eighth = 0.785398163397448309615660845819875721;
    const double angle = engine_() % 2 == 0 ? between(-4, 4) : eighth * static_cast<double>(engine_() % 9) + near;
    return {static_cast<Scalar>(length * std::sin(angle)), static_cast<Scalar>(length * std::cos(angle))};
  }

 private:
  std::mt19937_64 engine_{31};
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
};

TYPED_TEST(ArcTangent, IsWithinTwoUnitsInTheLastPlace) {
  Vectors<TypeParam> vectors;
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto [sine, cosine] = vectors.next();
    worst = std::max(worst, error_in_ulp(arc_tangent(sine, cosine), sine, cosine));
  }
  EXPECT_LE(worst, kLargestError);
  EXPECT_GT(worst, 0.5) << "as good as correctly rounded: the test measures nothing";
}

// The last lanes overlap others; eight lanes are two vectors on most processors.
TYPED_TEST(ArcTangent, IsTheSameInLanes) {
  constexpr int kCount = 11;
  Vectors<TypeParam> vectors;
  for (int round = 0; round < 100; ++round) {
    TypeParam sines[kCount], cosines[kCount], angles[kCount], eight[8];
    for (int i = 0; i < kCount; ++i) {
      const auto [sine, cosine] = vectors.next();
      sines[i] = sine;
      cosines[i] = cosine;
    }
    arc_tangents_of<kCount>(sines, cosines, angles);
    atan2(Lanes<TypeParam, 8>::load(sines), Lanes<TypeParam, 8>::load(cosines)).store(eight);
    for (int i = 0; i < kCount; ++i) EXPECT_LE(error_in_ulp(angles[i], sines[i], cosines[i]), kLargestError);
    for (int i = 0; i < 8; ++i) EXPECT_LE(error_in_ulp(eight[i], sines[i], cosines[i]), kLargestError);
    arc_tangents_of<2>(sines, cosines, angles);
    for (int i = 0; i < 2; ++i) EXPECT_LE(error_in_ulp(angles[i], sines[i], cosines[i]), kLargestError);
    // Pairs of any number.
    const TypeParam *s = sines, *c = cosines;
    arc_tangents_to(&angles[0], s[0], c[0], s[1], c[1], s[2], c[2], s[3], c[3], s[4], c[4], s[5], c[5], s[6], c[6]);
    for (int i = 0; i < 7; ++i) EXPECT_LE(error_in_ulp(angles[i], sines[i], cosines[i]), kLargestError);
    arc_tangents_to(&angles[0], s[1], c[1], s[0], c[0]);
    for (int i = 0; i < 2; ++i) EXPECT_LE(error_in_ulp(angles[i], sines[1 - i], cosines[1 - i]), kLargestError);
  }
}

// Zeros have signs, as in the C library.
TYPED_TEST(ArcTangent, OfZerosAndOnes) {
  constexpr TypeParam kValues[] = {0, TypeParam(-0.0), 1, -1};
  for (const TypeParam sine : kValues)
    for (const TypeParam cosine : kValues) {
      const TypeParam found = arc_tangent(sine, cosine), expected = std::atan2(sine, cosine);
      EXPECT_EQ(found, expected) << sine << " " << cosine;
      EXPECT_EQ(std::signbit(found), std::signbit(expected)) << sine << " " << cosine;
    }
}

TYPED_TEST(ArcTangent, KeepsNaN) {
  const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
  EXPECT_TRUE(std::isnan(arc_tangent(nan, TypeParam(1))));
  EXPECT_TRUE(std::isnan(arc_tangent(TypeParam(1), nan)));
}

// Lanes of other scalars use their function.
struct Other {
  double x;
  friend Other atan2(const Other& sine, const Other& cosine) { return {std::atan2(sine.x, cosine.x)}; }
};

TEST(ArcTangentOfOthers, IsTheirOwn) {
  EXPECT_EQ(arc_tangent(Other{1}, Other{-1}).x, std::atan2(1.0, -1.0));
  EXPECT_EQ(arc_tangent(1.0L, -1.0L), std::atan2(1.0L, -1.0L));
  const Other sines[] = {{1}, {2}}, cosines[] = {{3}, {4}};
  const auto found = atan2(Lanes<Other, 2>::gather(sines, 1), Lanes<Other, 2>::gather(cosines, 1));
  EXPECT_EQ(found[1].x, std::atan2(2.0, 4.0));
}

}  // namespace
}  // namespace robcogen
