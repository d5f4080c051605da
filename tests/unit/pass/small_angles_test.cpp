// Sines in lanes that do not need a check for large angles.
#include "pass/small_angles.h"

#include <gtest/gtest.h>

#include <string>

#include "../backend/programs.h"

namespace robcogen::pass::small_angles_test {
namespace {

// True if the angles `x`, in four lanes, are known to be small.
bool known(const std::string& angle) {
  const symbolic::Program program = test::described_program(
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
  return has_small_angles(program);
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

TEST(SmallAngles, AreThoseOfSinesInLanes) {
  EXPECT_FALSE(has_small_angles(test::described_program(
      "program limbs\ninput q joint_position a b c d\noutput out value 1 1\nsection limbs limbs\n"
      "tmp s = sin q[0]\ntmp z = s * q[1]\nreturn out z\n")));
}

}  // namespace
}  // namespace robcogen::pass::small_angles_test
