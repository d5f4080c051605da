// Blocks of programs with lanes, as lines of C++.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "backend/cpp/lower.h"
#include "programs.h"

namespace robcogen::backend::cpp::lower_blocks_test {
namespace {

std::string lowered(const std::string& statements, int outputs) {
  const symbolic::Program program = test::described_program(
      "program limbs\n"
      "input q joint_position a0 a1 b0 b1\n"
      "output out value " +
      std::to_string(outputs) + " 1\nsection limbs limbs\n" + statements);
  std::string result;
  for (const Line& line : lower(program, "limbs").lines) result += text(line) + "\n";
  return result;
}

TEST(LowerBlocks, InputsAreLoadedAtFirstUseAndOutputsStoredWhenTheLastColumnIsKnown) {
  EXPECT_EQ(
      lowered(
          "tmp s = gather q[0] q[2]\n"
          "tmp t = gather q[1] q[3]\n"
          "let x = s * t\n"
          "let y = x + s\n"
          "return out x@0 y@0 x@1 y@1\n",
          4),
      "// limbs\n"
      "const auto q_lanes = robcogen::load_lanes<2, 2, 2>(&q[0]);\n"
      "const Lanes2 x = q_lanes[0] * q_lanes[1];\n"
      "const Lanes2 y = x + q_lanes[0];\n"
      "robcogen::store_lanes<2>(&out[0], x, y);\n");
}

TEST(LowerBlocks, ConstantsAreFilledInFirstAndOnlyOnce) {
  EXPECT_EQ(
      lowered(
          "tmp s = gather q[0] q[3]\n"
          "let x = s * s\n"
          "let y = x + s\n"
          "return out x@0 0 -y@0 x@1 0 -y@1 0 0 0 0 x@0 0 0 1\n",
          14),
      "robcogen::fill<7>(&out[6], Scalar(0.0));\n"
      "// limbs\n"
      "const Lanes2 s = Lanes2::of(q[0], q[3]);\n"
      "const Lanes2 x = s * s;\n"
      "out[10] = x[0];\n"
      "const Lanes2 y = x + s;\n"
      "robcogen::store_lanes<3>(&out[0], x, Lanes2(Scalar(0.0)), -y);\n"
      "// constant elements\n"
      "out[13] = Scalar(1.0);\n");
}

TEST(LowerBlocks, TwoSumsOfLanesThatFollowEachOtherAreOneLine) {
  EXPECT_EQ(
      lowered(
          "tmp s = gather q[0] q[3]\n"
          "tmp t = s * s\n"
          "tmp u = t + s\n"
          "tmp first = sum_lanes t\n"
          "tmp second = sum_lanes u\n"
          "tmp third = sum_lanes s\n"
          "tmp x = first * third\n"
          "return out x -second second\n",
          3),
      "// limbs\n"
      "const Lanes2 s = Lanes2::of(q[0], q[3]);\n"
      "const Lanes2 t = s * s;\n"
      "const auto [first, second] = sum_lanes(t, t + s);\n"
      "out[2] = second;\n"
      "out[1] = -second;\n"
      "out[0] = first * sum_lanes(s);\n");
}

// Both sums share a line if they fit; otherwise their operands get lines of their own.
TEST(LowerBlocks, LongSumsOfLanesAreTakenOutOfTheirLine) {
  std::string statements = "tmp a_value_in_lanes_with_a_name = gather q[0] q[3]\n";
  for (const std::string sum : {"one", "two"}) {
    statements += "tmp " + sum + "0 = a_value_in_lanes_with_a_name * a_value_in_lanes_with_a_name\n";
    for (int k = 1; k < 4; ++k)
      statements +=
          "tmp " + sum + std::to_string(k) + " = " + sum + std::to_string(k - 1) + " + a_value_in_lanes_with_a_name\n";
  }
  statements += "tmp first = sum_lanes one3\ntmp second = sum_lanes two3\nreturn out first second\n";
  const std::string text = lowered(statements, 2);
  EXPECT_NE(text.find("const auto [first, second] = sum_lanes("), std::string::npos) << text;
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
    EXPECT_LE(text.find('\n', begin) - begin, 118u) << text;
}

// Even the names alone can be too long for one line.
TEST(LowerBlocks, SumsWithLongNamesHaveALineEach) {
  EXPECT_EQ(
      lowered(
          "tmp lanes_that_have_a_long_name = gather q[0] q[3]\n"
          "tmp others_that_have_a_long_name = lanes_that_have_a_long_name * lanes_that_have_a_long_name\n"
          "tmp first_sum_with_a_long_name = sum_lanes lanes_that_have_a_long_name\n"
          "tmp second_sum_with_a_long_name = sum_lanes others_that_have_a_long_name\n"
          "tmp x = others_that_have_a_long_name@0 * first_sum_with_a_long_name\n"
          "return out first_sum_with_a_long_name second_sum_with_a_long_name x\n",
          3),
      "// limbs\n"
      "const Lanes2 lanes_that_have_a_long_name = Lanes2::of(q[0], q[3]);\n"
      "const Lanes2 others_that_have_a_long_name = lanes_that_have_a_long_name * lanes_that_have_a_long_name;\n"
      "const Scalar first_sum_with_a_long_name = sum_lanes(lanes_that_have_a_long_name);\n"
      "out[0] = first_sum_with_a_long_name;\n"
      "const Scalar second_sum_with_a_long_name = sum_lanes(others_that_have_a_long_name);\n"
      "out[1] = second_sum_with_a_long_name;\n"
      "out[2] = others_that_have_a_long_name[0] * first_sum_with_a_long_name;\n");
}

TEST(LowerBlocks, SumsOfOtherLanesStayApart) {
  const std::string text = lowered(
      "tmp s = gather q[0] q[3]\n"
      "tmp t = gather q[0] q[3] q[1] q[2]\n"
      "tmp first = sum_lanes s\n"
      "tmp second = sum_lanes t\n"
      "return out first second\n",
      2);
  EXPECT_EQ(text.find("const auto ["), std::string::npos) << text;
}

TEST(LowerBlocks, SinesOfABlockOfTwoLanesAreComputedTogether) {
  EXPECT_EQ(
      lowered(
          "tmp s = gather q[0] q[2]\n"
          "tmp t = gather q[1] q[3]\n"
          "tmp c_s = cos s\n"
          "tmp s_t = sin t\n"
          "let x = c_s * s_t\n"
          "return out x@0 x@1\n",
          2),
      "// limbs\n"
      "const auto q_lanes = robcogen::load_lanes<2, 2, 2>(&q[0]);\n"
      "const robcogen::SinCosOf<Lanes2, 2> trig(&q_lanes[0]);\n"
      "const auto [s_s, c_s] = trig[0];\n"
      "const auto [s_t, c_t] = trig[1];\n"
      "const Lanes2 x = c_s * s_t;\n"
      "out[0] = x[0];\n"
      "out[1] = x[1];\n");
}

// One limb needs a sine that the others do not: all lanes are computed at once, and the limb reads its own.
TEST(LowerBlocks, ASingleLaneHasItsSineFromThoseOfAllLanes) {
  const std::string text = lowered(
      "tmp u = gather q[0] q[3]\n"
      "let x = u + 0.5\n"
      "tmp s = sin x@0\n"
      "tmp t = -0.25 * s\n"
      "tmp c = cos x\n"
      "tmp r = cos -x@1\n"
      "return out c@0 c@1 t r\n",
      4);
  EXPECT_NE(text.find("const auto [s_x, c_x] = robcogen::sincos(x);\n"), std::string::npos) << text;
  EXPECT_NE(text.find("Scalar(-0.25) * s_x[0]"), std::string::npos) << text;
  EXPECT_NE(text.find("out[3] = c_x[1];\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("sincos(x["), std::string::npos) << text;
}

// Angles that two limbs compute separately are two scalar angles.
TEST(LowerBlocks, SinesOfSingleLanesAreScalars) {
  const std::string text = lowered(
      "tmp u = gather q[0] q[3]\n"
      "let x = u + 0.5\n"
      "tmp s = sin x@0\n"
      "tmp c = cos x@1\n"
      "tmp r = cos x@0\n"
      "return out s c r x@0\n",
      4);
  EXPECT_NE(text.find("const auto [s_x_0, c_x_0] = robcogen::sincos(x[0]);\n"), std::string::npos) << text;
  EXPECT_NE(text.find("const Scalar c_x_1 = cos(x[1]);\n"), std::string::npos) << text;
}

TEST(LowerBlocks, LongListsGoOnInTheNextLine) {
  std::string statements = "tmp s = gather q[0] q[3]\n", first, second;
  for (int k = 0; k < 8; ++k) {
    const std::string name = "name_of_moderate_length_" + std::to_string(k);
    statements +=
        "let " + name + " = s * " + (k == 0 ? "s" : "name_of_moderate_length_" + std::to_string(k - 1)) + "\n";
    first += " " + name + "@0";
    second += " " + name + "@1";
  }
  const std::string result = lowered(statements + "return out" + first + second + "\n", 16);
  const std::size_t begin = result.find("robcogen::store_lanes");
  EXPECT_EQ(
      result.substr(begin),
      "robcogen::store_lanes<8>(\n"
      "      &out[0], name_of_moderate_length_0, name_of_moderate_length_1, name_of_moderate_length_2,\n"
      "      name_of_moderate_length_3, name_of_moderate_length_4, name_of_moderate_length_5, "
      "name_of_moderate_length_6,\n"
      "      name_of_moderate_length_7);\n");
}

// The lines of the kernel for small angles; empty if there is none.
std::string lines_of_small_angles(const std::string& statements) {
  const symbolic::Program program = test::described_program(
      "program limbs\ninput q joint_position a b c d\noutput out value 1 1\nsection limbs limbs\n" + statements +
      "return out z\n");
  const std::optional<Kernel> kernel = of_small_angles(lower(program, "limbs"));
  std::string result;
  if (!kernel) return result;
  for (const Line& line : kernel->lines) result += text(line) + "\n";
  return result;
}

TEST(LowerSmallAngles, AreMarkedInTheirLines) {
  const std::string text = lines_of_small_angles(
      "tmp u = gather q[0] q[1]\ntmp s = sin u\ntmp t = sin q[0]\ntmp y = s * t\ntmp z = sum_lanes y\n");
  EXPECT_NE(text.find("= robcogen::sincos_of_small(u);"), std::string::npos) << text;
  EXPECT_EQ(text.find("sincos_of_small(q[0])"), std::string::npos) << text;
}

// Sines of scalars have no such form, and sines in two lanes are computed together with others.
TEST(LowerSmallAngles, AreThoseOfLanesThatAreComputedAlone) {
  EXPECT_EQ(lines_of_small_angles("tmp s = sin q[0]\ntmp z = s * q[1]\n"), "");
  EXPECT_EQ(
      lines_of_small_angles("tmp u = gather q[0] q[2]\ntmp v = gather q[1] q[3]\ntmp s = sin u\ntmp t = sin v\n"
                            "tmp y = s * t\ntmp z = sum_lanes y\n"),
      "");
}

}  // namespace
}  // namespace robcogen::backend::cpp::lower_blocks_test
