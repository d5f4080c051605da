// Compares lanes with the same operation on each scalar.
#include "robcogen/lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "lane_shapes.h"
#include "robcogen/magnitude.h"
#include "robcogen/sincos_of.h"

namespace robcogen {
namespace {

// Random numbers for lanes.
template <class Scalar, int kSize>
struct Random {
  explicit Random(unsigned seed) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> unit(-10, 10);
    for (Scalar& x : numbers) x = static_cast<Scalar>(unit(generator));
  }
  Lanes<Scalar, kSize> lanes() const { return Lanes<Scalar, kSize>::load(numbers); }

  Scalar numbers[kSize];
};

template <class Shape>
class LanesOf : public testing::Test {};

TYPED_TEST_SUITE(LanesOf, LaneShapes);

TYPED_TEST(LanesOf, ComputeEachLane) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kSize = TypeParam::kSize;
  const Random<Scalar, kSize> x(1), y(2);
  const Lanes<Scalar, kSize> a = x.lanes(), b = y.lanes();
  const Lanes<Scalar, kSize> sum = a + b, difference = a - b, product = a * b, quotient = a / b, negative = -a;
  const Lanes<Scalar, kSize> root = sqrt(a * a), without_sign = magnitude(a);
  for (int i = 0; i < kSize; ++i) {
    EXPECT_EQ(sum[i], x.numbers[i] + y.numbers[i]);
    EXPECT_EQ(difference[i], x.numbers[i] - y.numbers[i]);
    EXPECT_EQ(product[i], x.numbers[i] * y.numbers[i]);
    EXPECT_EQ(quotient[i], x.numbers[i] / y.numbers[i]);
    EXPECT_EQ(negative[i], -x.numbers[i]);
    EXPECT_EQ(root[i], std::sqrt(x.numbers[i] * x.numbers[i]));
    EXPECT_EQ(without_sign[i], std::abs(x.numbers[i]));
    EXPECT_EQ(magnitude(x.numbers[i]), std::abs(x.numbers[i]));
  }
}

// A sum of at most 16 numbers below 10, in another order: 16 roundings, of partial sums below 160.
template <class Scalar>
constexpr double kRoundingOfSum = 16 * 160 * std::numeric_limits<Scalar>::epsilon();

TYPED_TEST(LanesOf, AddUpAloneAndInPairs) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kSize = TypeParam::kSize;
  const Random<Scalar, kSize> x(1), y(2);
  long double sum_of_x = 0, sum_of_y = 0;
  for (int i = 0; i < kSize; ++i) {
    sum_of_x += static_cast<long double>(x.numbers[i]);
    sum_of_y += static_cast<long double>(y.numbers[i]);
  }
  EXPECT_LE(std::abs(sum_lanes(x.lanes()) - sum_of_x), kRoundingOfSum<Scalar>);
  const auto [first, second] = sum_lanes(x.lanes(), y.lanes());
  EXPECT_LE(std::abs(first - sum_of_x), kRoundingOfSum<Scalar>);
  EXPECT_LE(std::abs(second - sum_of_y), kRoundingOfSum<Scalar>);
}

TYPED_TEST(LanesOf, SpreadOneNumber) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kSize = TypeParam::kSize;
  for (const Scalar x : {Scalar(0.3), -Scalar(0), std::numeric_limits<Scalar>::infinity()}) {
    const Lanes<Scalar, kSize> all(x);
    for (int i = 0; i < kSize; ++i) {
      EXPECT_EQ(all[i], x);
      EXPECT_EQ(std::signbit(all[i]), std::signbit(x));
    }
  }
  const Lanes<Scalar, kSize> literal(0.1);
  EXPECT_EQ(literal[kSize - 1], Scalar(0.1));
}

TYPED_TEST(LanesOf, AreStoredInOrder) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kSize = TypeParam::kSize;
  const Random<Scalar, kSize> x(1);
  Scalar back[kSize + 1] = {};
  x.lanes().store(back);
  for (int i = 0; i < kSize; ++i) EXPECT_EQ(back[i], x.numbers[i]);
  EXPECT_EQ(back[kSize], 0);
}

TYPED_TEST(LanesOf, GatherAndScatterAtADistance) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kSize = TypeParam::kSize;
  const Random<Scalar, kSize> x(1);
  Scalar spread[3 * kSize] = {}, back[3 * kSize] = {};
  for (int i = 0; i < kSize; ++i) spread[3 * i] = x.numbers[i];
  const auto lanes = Lanes<Scalar, kSize>::gather(spread, 3);
  for (int i = 0; i < kSize; ++i) EXPECT_EQ(lanes[i], x.numbers[i]);
  lanes.scatter(back, 3);
  for (int i = 0; i < 3 * kSize; ++i) EXPECT_EQ(back[i], spread[i]);
}

TYPED_TEST(LanesOf, ConvertBetweenPrecisions) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kSize = TypeParam::kSize;
  const Random<Scalar, kSize> x(1);
  double wide[kSize];
  x.lanes().store(wide);
  const auto doubles = Lanes<double, kSize>::load(x.numbers);
  for (int i = 0; i < kSize; ++i) {
    EXPECT_EQ(wide[i], static_cast<double>(x.numbers[i]));
    EXPECT_EQ(doubles[i], wide[i]);
  }
}

// The polynomials are those for single angles, whose errors sincos_of_test measures.
TYPED_TEST(LanesOf, SinesAreThoseOfSingleAngles) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kSize = TypeParam::kSize;
  using L = Lanes<Scalar, kSize>;
  const L angles[3] = {
      Random<Scalar, kSize>(1).lanes(), Random<Scalar, kSize>(2).lanes(), Random<Scalar, kSize>(3).lanes()};
  const SinCosOf<L, 3> found(angles);
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < kSize; ++i) {
      const Scalar one[1] = {angles[k][i]};
      const SinCosOf<Scalar, 1> expected(one);
      EXPECT_EQ(found[k].sin[i], expected[0].sin);
      EXPECT_EQ(found[k].cos[i], expected[0].cos);
    }
  }
  const L sine = sin(angles[1]), cosine = cos(angles[1]);
  EXPECT_EQ(sine[0], found[1].sin[0]);
  EXPECT_EQ(cosine[0], found[1].cos[0]);
}

TYPED_TEST(LanesOf, LargeAnglesAndNoNumbersStayInTheirLane) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kSize = TypeParam::kSize;
  const Scalar nan = std::numeric_limits<Scalar>::quiet_NaN(), infinity = std::numeric_limits<Scalar>::infinity();
  const Random<Scalar, kSize> usual(1);
  const auto others = robcogen::sincos(usual.lanes());
  for (const Scalar odd : {Scalar(123456.789), Scalar(-1e30), nan, infinity}) {
    for (int lane = 0; lane < kSize; ++lane) {
      Random<Scalar, kSize> x = usual;
      x.numbers[lane] = odd;
      const auto found = robcogen::sincos(x.lanes());
      for (int i = 0; i < kSize; ++i) {
        if (i != lane) {
          EXPECT_EQ(found.sin[i], others.sin[i]);
          EXPECT_EQ(found.cos[i], others.cos[i]);
        } else if (std::isfinite(odd)) {
          EXPECT_LE(std::abs(found.sin[i] - std::sin(odd)), std::numeric_limits<Scalar>::epsilon());
          EXPECT_LE(std::abs(found.cos[i] - std::cos(odd)), std::numeric_limits<Scalar>::epsilon());
        } else {
          EXPECT_TRUE(std::isnan(found.sin[i]) && std::isnan(found.cos[i]));
        }
      }
    }
  }
}

TYPED_TEST(LanesOf, SinesOfSmallAnglesAreTheSame) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kSize = TypeParam::kSize;
  const Scalar limit = std::is_same_v<Scalar, float> ? Scalar(39) : Scalar(9000);
  for (const Scalar to : {Scalar(1), Scalar(10), limit}) {
    const Lanes<Scalar, kSize> x = Random<Scalar, kSize>(1).lanes() * Lanes<Scalar, kSize>(to);
    const auto expected = robcogen::sincos(x), found = sincos_of_small(x);
    for (int i = 0; i < kSize; ++i) {
      EXPECT_EQ(found.sin[i], expected.sin[i]);
      EXPECT_EQ(found.cos[i], expected.cos[i]);
    }
  }
}

// For as many angles as lanes, and for one more: with whole blocks, and with a last block that overlaps the one before.
template <int kCount, class Scalar>
void expect_judged() {
  constexpr bool kSingle = std::is_same_v<Scalar, float>;
  constexpr Scalar kSmall = kSingle ? Scalar(84) : Scalar(2.1e4), kLarge = kSingle ? Scalar(121) : Scalar(3.01e4);
  const Scalar nan = std::numeric_limits<Scalar>::quiet_NaN(), infinity = std::numeric_limits<Scalar>::infinity();
  for (int place = 0; place < kCount; ++place) {
    Scalar angles[kCount] = {};
    EXPECT_TRUE(are_small<kCount>(angles));
    for (const Scalar small : {kSmall, -kSmall}) {
      angles[place] = small;
      EXPECT_TRUE(are_small<kCount>(angles));
    }
    for (const Scalar large : {kLarge, -kLarge, Scalar(1e30), infinity, -infinity, nan}) {
      angles[place] = large;
      EXPECT_FALSE(are_small<kCount>(angles)) << kCount << " " << place << " " << large;
    }
  }
}

TYPED_TEST(LanesOf, LargeAnglesAreFoundAtEachPlace) {
  expect_judged<TypeParam::kSize, typename TypeParam::Scalar>();
  expect_judged<TypeParam::kSize + 1, typename TypeParam::Scalar>();
}

// Functions over limbs in lanes have such types when they are evaluated for several states.
TEST(Lanes, MayBeLanesThemselves) {
  using Inner = Lanes<double, 4>;
  using Outer = Lanes<Inner, 4>;
  Inner inner[4];
  for (unsigned i = 0; i < 4; ++i) inner[i] = Random<double, 4>(i).lanes();
  const Outer a = Outer::load(inner), b = sqrt(a * a + Outer(2)) / Outer(0.5) - (-a);
  const SinCosOf<Outer, 1> both(&a);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      const double x = inner[i][k];
      EXPECT_NEAR(b[i][k], std::sqrt(x * x + 2) / 0.5 + x, 1e-14);  // rounded differently where products fuse
      EXPECT_NEAR(both[0].sin[i][k], std::sin(x), 1e-15);
      EXPECT_NEAR(both[0].cos[i][k], std::cos(x), 1e-15);
    }
  }
}

}  // namespace
}  // namespace robcogen
