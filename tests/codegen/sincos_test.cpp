#include "robcogen/sincos.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace robcogen::sincos_test {
namespace {

TEST(SinCos, AgreesWithTheStandardLibrary) {
  for (double x = -10; x < 10; x += 0.0137) {
    const auto [s, c] = sincos(x);
    EXPECT_DOUBLE_EQ(s, std::sin(x));
    EXPECT_DOUBLE_EQ(c, std::cos(x));
    const auto f = static_cast<float>(x);
    const auto [sf, cf] = sincos(f);
    EXPECT_FLOAT_EQ(sf, std::sin(f));
    EXPECT_FLOAT_EQ(cf, std::cos(f));
  }
}

TEST(SinCos, TakesAnyScalar) {
  const std::complex<double> z(0.3, 0.4);
  const SinCos<std::complex<double>> r = sincos(z);
  EXPECT_EQ(r.sin, std::sin(z));
  EXPECT_EQ(r.cos, std::cos(z));
  EXPECT_EQ(sincos(0.5L).sin, std::sin(0.5L));
}

TEST(SinCos, NotANumberStaysOne) {
  EXPECT_TRUE(std::isnan(sincos(INFINITY).sin));
  EXPECT_TRUE(std::isnan(sincos(static_cast<double>(NAN)).cos));
}

}  // namespace
}  // namespace robcogen::sincos_test
