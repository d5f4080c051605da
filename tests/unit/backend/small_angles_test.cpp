// Sines in lanes that do not need a check for large angles.
#include "backend/cpp/small_angles.h"

#include <gtest/gtest.h>

#include "backend/cpp/lower.h"
#include "programs.h"

namespace robcogen::backend::cpp {
namespace {

// True if the angles `x`, in four lanes, are known to be small.
bool known(const std::string& angle) {
  const symbolic::Program program = test::program(
      "program limbs\n"
      "input parameters parameters turn\n"
      "input q joint_position a b c d e f g h\n"
      "output out value 1 1\n"
      "section limbs limbs\n"
      "tmp u = gather q[0] q[2] q[4] q[7]\n"
      "tmp v = gather q[1] q[3] q[5] q[6]\n" +
      angle +
      "tmp s = sin x\n"
      "tmp c = cos x\n"
      "tmp y = s * c\n"
      "tmp sum = sum_lanes y\n"
      "return out sum\n");
  return has_small_angles(program, lower(program, "limbs"));
}

TEST(SmallAngles, ArePositionsOfEitherSign) {
  EXPECT_TRUE(known("tmp x = gather q[0] q[2] q[4] q[7]\n"));
  EXPECT_TRUE(known("tmp signs = gather 1 -1 1 -1\ntmp x = u * signs\n"));
}

TEST(SmallAngles, AreSumsOfAtMostThree) {
  EXPECT_TRUE(known("tmp t = u - v\ntmp x = t + q[0]\n"));
  EXPECT_TRUE(known("tmp x = u + 0.5\n"));
  EXPECT_FALSE(known("tmp t = u + v\ntmp w = t + q[0]\ntmp x = w + q[1]\n"));
}

// In float, small positions are below 120 rad, and the polynomials are valid up to 400 rad.
TEST(SmallAngles, AreSmallInFloatToo) {
  EXPECT_TRUE(known("tmp x = u + 270\n"));
  EXPECT_FALSE(known("tmp x = u + 290\n"));
}

TEST(SmallAngles, AreNoOtherValues) {
  EXPECT_FALSE(known("tmp x = u + parameters[0]\n"));
  EXPECT_FALSE(known("tmp x = u * 4\n"));
  EXPECT_FALSE(known("tmp x = u / v\n"));
  EXPECT_FALSE(known("tmp t = gather parameters[0] q[0] q[1] q[2]\ntmp x = t * t\n"));
}

// Sines of scalars have no such check, and sines in two lanes are computed together with others.
TEST(SmallAngles, AreThoseOfLanesThatAreComputedAlone) {
  const auto known_of = [](const std::string& statements) {
    const symbolic::Program program = test::program(
        "program limbs\ninput q joint_position a b c d\noutput out value 1 1\nsection limbs limbs\n" + statements +
        "return out z\n");
    return has_small_angles(program, lower(program, "limbs"));
  };
  EXPECT_FALSE(known_of("tmp s = sin q[0]\ntmp z = s * q[1]\n"));
  EXPECT_FALSE(
      known_of("tmp u = gather q[0] q[2]\ntmp v = gather q[1] q[3]\ntmp s = sin u\ntmp t = sin v\n"
               "tmp y = s * t\ntmp z = sum_lanes y\n"));
}

TEST(SmallAngles, AreMarkedInTheirLines) {
  const symbolic::Program program = test::program(
      "program limbs\ninput q joint_position a b\noutput out value 1 1\nsection limbs limbs\n"
      "tmp u = gather q[0] q[1]\ntmp s = sin u\ntmp t = sin q[0]\ntmp y = s * t\ntmp z = sum_lanes y\n"
      "return out z\n");
  std::string result;
  for (const Line& line : of_small_angles(lower(program, "limbs")).lines) result += text(line) + "\n";
  EXPECT_NE(result.find("= robcogen::sincos_of_small(u);"), std::string::npos) << result;
  EXPECT_EQ(result.find("sincos_of_small(q[0])"), std::string::npos) << result;
}

}  // namespace
}  // namespace robcogen::backend::cpp
