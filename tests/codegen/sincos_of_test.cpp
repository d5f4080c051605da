// Sines and cosines of many angles at once, compared with those in long double.
#include "robcogen/sincos_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <complex>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace robcogen {
namespace {

constexpr long double kHalfPi = 1.57079632679489661923132169163975144L;
// The range of the polynomials (rad), and the number of multiples of pi / 2 within it.
template <class Scalar>
constexpr Scalar kLimit = std::is_same_v<Scalar, float> ? Scalar(400) : Scalar(1e5);
template <class Scalar>
constexpr int kMultiples = std::is_same_v<Scalar, float> ? 254 : 63661;

// Distance to the next number of larger magnitude.
template <class Scalar>
double ulp(Scalar x) {
  const Scalar size = std::abs(x);
  return static_cast<double>(std::nextafter(size, std::numeric_limits<Scalar>::infinity()) - size);
}

template <class Scalar>
double error_in_ulp(Scalar found, long double exact) {
  const auto error = static_cast<double>(std::abs(static_cast<long double>(found) - exact));
  return error / ulp(static_cast<Scalar>(exact));
}

// The largest errors over all angles that were added. Seven are computed at a time, so that vectors have unused lanes.
template <class Scalar>
class Errors {
 public:
  void add(Scalar x) {
    angles_[count_++] = x;
    if (count_ < 7) return;
    count_ = 0;
    const SinCosOf<Scalar, 7> found(angles_);
    for (int i = 0; i < 7; ++i) {
      const auto exact = static_cast<long double>(angles_[i]);
      worst =
          std::max({worst, error_in_ulp(found[i].sin, std::sin(exact)), error_in_ulp(found[i].cos, std::cos(exact))});
    }
  }

  double worst = 0;

 private:
  Scalar angles_[7];
  int count_ = 0;
};

int volume() {
  const char* wanted = std::getenv("ROBCOGEN_TEST_ANGLES");
  return wanted != nullptr ? std::atoi(wanted) : 2'000'000;
}

template <class Scalar>
double worst_of_random() {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  Errors<Scalar> errors;
  const double ranges[] = {kLimit<Scalar>, kLimit<Scalar> / 100, 6.3, 1, 1e-3, 1e-9};
  for (int i = 0; i < volume(); ++i) errors.add(static_cast<Scalar>(ranges[i % 6] * unit(generator)));
  return errors.worst;
}

// Eight neighbours of each multiple of pi / 2, where the sine or cosine is small and the reduction loses most digits.
template <class Scalar>
double worst_of_multiples() {
  Errors<Scalar> errors;
  for (int k = 0; k <= kMultiples<Scalar>; ++k) {
    const auto center = static_cast<Scalar>(k * kHalfPi);
    for (const Scalar to : {-std::numeric_limits<Scalar>::infinity(), std::numeric_limits<Scalar>::infinity()}) {
      Scalar x = center;
      for (int i = 0; i < 4; ++i, x = std::nextafter(x, to)) errors.add(x);
    }
  }
  return errors.worst;
}

class SinCosOfManyAngles : public testing::Test {
 protected:
  void SetUp() override {
    if (LDBL_MANT_DIG < 64) GTEST_SKIP() << "long double has no more digits than double";
  }
};

// Prints the measurements, for the exhaustive run.
double said(const char* what, double worst) {
  std::printf("%s: %.4f ulp at most\n", what, worst);
  return worst;
}

TEST_F(SinCosOfManyAngles, IsWithinOneUlp) {
  const double worst = said("double, random angles", worst_of_random<double>());
  EXPECT_LT(worst, 0.9);
  EXPECT_GT(worst, 0.4);  // the measurement works
}

TEST_F(SinCosOfManyAngles, IsWithinOneUlpAtMultiplesOfARightAngle) {
  EXPECT_LT(said("double, neighbours of multiples of pi / 2", worst_of_multiples<double>()), 0.9);
}

// The largest error that is documented for float, in single precision and in lanes.
constexpr double kFloatLimit = 1.5;

TEST_F(SinCosOfManyAngles, OfFloatAreWithinOneAndAHalfUlp) {
  const double worst = said("float, random angles", worst_of_random<float>());
  EXPECT_LT(worst, kFloatLimit);
  EXPECT_GT(worst, 0.4);
  EXPECT_LT(said("float, neighbours of multiples of pi / 2", worst_of_multiples<float>()), kFloatLimit);
}

// The last place of the float nearest to x.
double float_ulp(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1023;
  bits = static_cast<std::uint64_t>(std::max(exponent, -126) - 23 + 1023) << 52;
  double ulp;
  std::memcpy(&ulp, &bits, sizeof(ulp));
  return ulp;
}

double float_error(float found, double exact) {
  return std::abs(static_cast<double>(found) - exact) / float_ulp(exact);
}

// The largest error of lanes for every stride-th float below the limit, of both signs.
template <int kSize>
double worst_of_floats(std::uint32_t stride) {
  using L = Lanes<float, kSize>;
  std::uint32_t end;
  const float limit = kLimit<float>;
  std::memcpy(&end, &limit, sizeof(end));
  double worst = 0;
  for (std::uint32_t next = 0; next <= end;) {
    float angles[kSize], sines[kSize], cosines[kSize];
    for (int i = 0; i < kSize; ++i, next += stride) {
      const std::uint32_t bits = std::min(next, end) | static_cast<std::uint32_t>(i % 2) << 31;
      std::memcpy(&angles[i], &bits, sizeof(bits));
    }
    const auto found = robcogen::sincos(L::load(angles));
    found.sin.store(sines);
    found.cos.store(cosines);
    for (int i = 0; i < kSize; ++i) {
      const auto exact = static_cast<double>(angles[i]);
      worst = std::max({worst, float_error(sines[i], std::sin(exact)), float_error(cosines[i], std::cos(exact))});
    }
  }
  return worst;
}

// In the exhaustive run, all floats: std::sin of double is accurate enough to measure them.
TEST(SinCosOfAllFloats, AreWithinOneAndAHalfUlpInLanes) {
  const char* wanted = std::getenv("ROBCOGEN_TEST_FLOAT_STRIDE");
  const auto stride = static_cast<std::uint32_t>(wanted != nullptr ? std::atoi(wanted) : 1009);
  EXPECT_LT(said("float, lanes of 4", worst_of_floats<4>(stride)), kFloatLimit);
  EXPECT_LT(said("float, lanes of 8", worst_of_floats<8>(stride == 1 ? 9 : stride)), kFloatLimit);
}

// Few angles, which may be left to the C library, and angles that are not contiguous.
template <class Scalar>
void expect_few() {
  const Scalar angles[6] = {Scalar(0.3), Scalar(-1.2), Scalar(2.5), Scalar(0.1), Scalar(4), Scalar(-3)};
  Scalar sine[6] = {}, cosine[6] = {};
  const auto expect = [&](int place, int angle) {
    EXPECT_NEAR(sine[place], std::sin(angles[angle]), std::numeric_limits<Scalar>::epsilon());
    EXPECT_NEAR(cosine[place], std::cos(angles[angle]), std::numeric_limits<Scalar>::epsilon());
  };
  sincos_of<1>(angles + 1, sine, cosine);
  expect(0, 1);
  sincos_of<2>(angles + 1, sine, cosine);
  for (int i = 0; i < 2; ++i) expect(i, i + 1);
  sincos_of<3>(angles + 2, sine, cosine);
  for (int i = 0; i < 3; ++i) expect(i, i + 2);
  sincos_to<5, 0, 3>(angles, sine, cosine);
  expect(5, 0);
  expect(0, 1);
  expect(3, 2);
  sincos_at<0, 2, 4, 5>(angles, sine, cosine);
  for (const int i : {0, 2, 4, 5}) expect(i, i);
  called::sincos_of<5>(angles + 1, sine, cosine);
  for (int i = 0; i < 5; ++i) expect(i, i + 1);
  called::sincos_to<4, 1>(angles, sine, cosine);
  expect(4, 0);
  expect(1, 1);
  called::sincos_at<0, 1, 3>(angles, sine, cosine);
  for (const int i : {0, 1, 3}) expect(i, i);
}

// Writes the sine and cosine of each angle to its place, and nothing to other places. Some of the angles are of any
// size.
template <class Scalar, int... kTo>
void expect_at_places() {
  constexpr int kPlaces[] = {kTo...}, kCount = sizeof...(kTo);
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity(), kUnwritten = 7;
  const Scalar different[] = {Scalar(0.3), Scalar(1e6), Scalar(-2.5), kInfinity - kInfinity, Scalar(4), Scalar(-5e7)};
  for (int first = 0; first < 6; ++first) {
    Scalar angles[kCount], sine[12], cosine[12];
    for (int i = 0; i < kCount; ++i) angles[i] = different[(first * i) % 6] + Scalar(0.125) * Scalar(i);
    for (int i = 0; i < 12; ++i) sine[i] = cosine[i] = kUnwritten;
    robcogen::sincos_to<kTo...>(angles, sine, cosine);
    for (int place = 0; place < 12; ++place) {
      const auto* at = std::find(std::begin(kPlaces), std::end(kPlaces), place);
      if (at == std::end(kPlaces)) {
        EXPECT_EQ(sine[place], kUnwritten);
        EXPECT_EQ(cosine[place], kUnwritten);
        continue;
      }
      const Scalar x = angles[at - kPlaces];
      if (!std::isfinite(x)) {
        EXPECT_TRUE(std::isnan(sine[place]) && std::isnan(cosine[place]));
        continue;
      }
      EXPECT_NEAR(sine[place], std::sin(x), std::numeric_limits<Scalar>::epsilon()) << x;
      EXPECT_NEAR(cosine[place], std::cos(x), std::numeric_limits<Scalar>::epsilon()) << x;
    }
  }
}

template <class Scalar>
void expect_at_all_kinds_of_places() {
  expect_at_places<Scalar, 3>();
  expect_at_places<Scalar, 3, 1>();
  expect_at_places<Scalar, 1, 2, 3>();
  expect_at_places<Scalar, 2, 3, 4, 5>();
  expect_at_places<Scalar, 1, 2, 3, 4, 6>();
  expect_at_places<Scalar, 0, 1, 2, 3, 5, 4>();
  expect_at_places<Scalar, 11, 9, 7, 5, 3, 1, 0, 2, 4>();
}

TEST(SinCosOf, AnglesGoToTheirPlaces) {
  expect_at_all_kinds_of_places<double>();
  expect_at_all_kinds_of_places<float>();
}

TEST(SinCosOf, FewAnglesAndAnglesThatStandApart) {
  expect_few<double>();
  expect_few<float>();
}

// An angle has the same sine in a group of any size.
TEST(SinCosOf, LanesDoNotMix) {
  const double angles[9] = {0.3, -1.2, 2.5, 0.1, 4, -3, 1e-9, 77, -1234.5};
  double sine[9], cosine[9], again[9], cosine_again[9];
  sincos_of<9>(angles, sine, cosine);
  sincos_of<4>(angles + 5, again, cosine_again);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(again[i], sine[5 + i]);
    EXPECT_EQ(cosine_again[i], cosine[5 + i]);
  }
}

template <class Scalar>
void expect_as_the_library(const std::vector<Scalar>& angles) {
  for (const Scalar x : angles) {
    const Scalar all[5] = {1, x, 2, -x, 3};
    const SinCosOf<Scalar, 5> found(all);
    for (int i = 0; i < 5; ++i) {
      if (std::isfinite(all[i])) {
        EXPECT_NEAR(found[i].sin, std::sin(all[i]), std::numeric_limits<Scalar>::epsilon()) << all[i];
        EXPECT_NEAR(found[i].cos, std::cos(all[i]), std::numeric_limits<Scalar>::epsilon()) << all[i];
      } else {
        EXPECT_TRUE(std::isnan(found[i].sin) && std::isnan(found[i].cos)) << all[i];
      }
    }
  }
}

TEST(SinCosOf, LeavesLargeAnglesToTheLibrary) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  expect_as_the_library<double>({1e5, std::nextafter(1e5, 2e5), 123456.789, 1e15, 1e300, infinity, nan});
  expect_as_the_library<float>(
      {400, 402, 405, std::nextafter(405.f, 500.f), 1e5f, 123456.789f, 1e15f, 1e38f, static_cast<float>(infinity),
       static_cast<float>(nan)});
}

TEST(SinCosOf, OfTheSmallestIsTheAngle) {
  const double angles[4] = {0.0, -0.0, std::numeric_limits<double>::denorm_min(), -DBL_MIN};
  const SinCosOf<double, 4> found(angles);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].sin, angles[i]);
    EXPECT_EQ(std::signbit(found[i].sin), std::signbit(angles[i]));
    EXPECT_EQ(found[i].cos, 1);
  }
}

TEST(SinCosOf, AnyScalarUsesItsOwn) {
  const std::complex<double> z[2] = {{0.5, 0.25}, {-1, 2}};
  const SinCosOf<std::complex<double>, 2> found(z);
  EXPECT_EQ(found[1].sin, std::sin(z[1]));
  EXPECT_EQ(found[1].cos, std::cos(z[1]));
}

}  // namespace
}  // namespace robcogen
