#include "backend/cpp/lower.h"

#include <gtest/gtest.h>

#include "programs.h"

namespace robcogen::backend::cpp::lower_test {
namespace {

using test::leg_program;

std::string lowered(const symbolic::Program& program) {
  std::string result;
  for (const Line& line : lower(program, "leg").lines) result += text(line) + "\n";
  return result;
}

std::string lowered(const std::string& statements, int outputs = 1) {
  return lowered(leg_program(statements, outputs));
}

TEST(Lower, UnnamedStatementsStandInsideTheirUser) {
  EXPECT_EQ(
      lowered("tmp t0 = q[0] * qd[0]\n"
              "tmp t1 = q[1] * qd[1]\n"
              "let hip_wx = t0 + t1\n"
              "let hip_wy = hip_wx - qd[1]\n"
              "return tau hip_wy\n"),
      "// link hip: velocity\n"
      "const Scalar hip_wx = q[0] * qd[0] + q[1] * qd[1];\n"
      "tau[0] = hip_wx - qd[1];\n");
}

TEST(Lower, NamedStatementsAndThoseUsedTwiceAreDefinitions) {
  EXPECT_EQ(
      lowered("let hip_a = q[0] * qd[0]\n"
              "tmp t1 = hip_a + q[1]\n"
              "tmp t2 = t1 * t1\n"
              "return tau t2\n"),
      "// link hip: velocity\n"
      "const Scalar hip_a = q[0] * qd[0];\n"
      "const Scalar t1 = hip_a + q[1];\n"
      "tau[0] = t1 * t1;\n");
}

TEST(Lower, EvaluationOrderIsThatOfTheProgram) {
  EXPECT_EQ(
      lowered("tmp t0 = q[1] + qd[0]\n"
              "tmp t1 = q[0] + t0\n"
              "tmp t2 = qd[1] - t1\n"
              "tmp t3 = t2 / -t2\n"
              "return tau t3\n"),
      "// link hip: velocity\n"
      "const Scalar t2 = qd[1] - (q[0] + (q[1] + qd[0]));\n"
      "tau[0] = -t2 / t2;\n");
}

TEST(Lower, ParametersThatAreReadAreNamedFirst) {
  const symbolic::Program program = test::described_program(
      "program leg\n"
      "input parameters parameters length unused mass q\n"
      "input q joint_position HIP\n"
      "output tau joint_force 1 1\n"
      "section hip link hip\n"
      "in 0\n"
      "tmp t0 = parameters[2] * q[0]\n"
      "tmp t1 = parameters[0] * t0\n"
      "tmp t2 = parameters[3] + t1\n"
      "return tau t2\n");
  EXPECT_EQ(
      lowered(program),
      "const Scalar& length = parameters[0];\n"
      "const Scalar& mass = parameters[2];\n"
      "const Scalar& q_2 = parameters[3];\n"
      "// link hip\n"
      "tau[0] = q_2 + length * (mass * q[0]);\n");
}

TEST(Lower, SectionsBecomeComments) {
  EXPECT_EQ(
      lowered("let hip_wx = q[0] + qd[0]\n"
              "in 1\n"
              "let knee_wx = hip_wx + hip_wx\n"
              "in 0\n"
              "let hip_wy = knee_wx * hip_wx\n"
              "return tau hip_wy\n"),
      "// link hip: velocity\n"
      "const Scalar hip_wx = q[0] + qd[0];\n"
      "// link knee: velocity\n"
      "const Scalar knee_wx = hip_wx + hip_wx;\n"
      "// link hip: velocity\n"
      "tau[0] = knee_wx * hip_wx;\n");
}

TEST(Lower, OnlyFusableProductsCrossSections) {
  EXPECT_EQ(
      lowered("tmp t0 = q[0] * qd[0]\n"
              "tmp t1 = q[1] + qd[1]\n"
              "in 1\n"
              "tmp t2 = t0 + qd[0]\n"
              "tmp t3 = t1 * t2\n"
              "return tau t3\n"),
      "// link hip: velocity\n"
      "const Scalar t1 = q[1] + qd[1];\n"
      "// link knee: velocity\n"
      "tau[0] = t1 * (q[0] * qd[0] + qd[0]);\n");
}

TEST(Lower, SinesAndCosinesOfInputsComeFirstInPairs) {
  EXPECT_EQ(
      lowered("let a = qd[0] + qd[1]\n"
              "tmp t1 = cos q[1]\n"
              "tmp t2 = sin q[1]\n"
              "tmp t3 = cos q[0]\n"
              "tmp t4 = t1 * a\n"
              "tmp t5 = t2 * a\n"
              "tmp t6 = t4 - t5\n"
              "tmp t7 = t6 * t3\n"
              "return tau t7\n"),
      "const Scalar c_HFE = cos(q[0]);\n"
      "const auto [s_KFE, c_KFE] = robcogen::sincos(q[1]);\n"
      "// link hip: velocity\n"
      "const Scalar a = qd[0] + qd[1];\n"
      "tau[0] = (c_KFE * a - s_KFE * a) * c_HFE;\n");
}

TEST(Lower, ComputedAnglesAreDefinedBeforeTheirPair) {
  EXPECT_EQ(
      lowered("tmp hip_t0 = q[0] + 0.5\n"
              "tmp hip_t1 = sin -hip_t0\n"
              "tmp hip_t2 = cos hip_t0\n"
              "tmp hip_t3 = hip_t1 * hip_t2\n"
              "return tau hip_t3\n"),
      "// link hip: velocity\n"
      "const Scalar hip_t0 = q[0] + Scalar(0.5);\n"
      "const auto [s_hip_t0, c_hip_t0] = robcogen::sincos(hip_t0);\n"
      "tau[0] = -s_hip_t0 * c_hip_t0;\n");
}

TEST(Lower, FunctionsFoundByArgumentDependentLookupAreListed) {
  const Kernel kernel = lower(
      leg_program("tmp t0 = sqrt q[0]\n"
                  "tmp t1 = sin q[1]\n"
                  "tmp t2 = t0 * t1\n"
                  "return tau t2\n"),
      "leg");
  EXPECT_EQ(kernel.functions, (std::vector<std::string>{"sin", "sqrt"}));
}

TEST(Lower, TheRootOfASquareIsAMagnitude) {
  EXPECT_EQ(
      lowered("let hip_wx = q[0] - qd[0]\n"
              "tmp t1 = hip_wx * hip_wx\n"
              "tmp t2 = sqrt t1\n"
              "return tau t2\n"),
      "// link hip: velocity\n"
      "const Scalar hip_wx = q[0] - qd[0];\n"
      "tau[0] = magnitude(hip_wx);\n");
  EXPECT_NE(
      lowered(
          "tmp t1 = q[0] * q[0]\n"
          "tmp t2 = sqrt t1\n"
          "return tau t2 t1\n",
          2)
          .find("sqrt("),
      std::string::npos)
      << "the square is needed itself";
}

TEST(Lower, EqualElementsAreComputedOnceAndStoredTogether) {
  EXPECT_EQ(
      lowered(
          "tmp t0 = q[0] + q[1]\n"
          "tmp t1 = q[0] * q[1]\n"
          "tmp t2 = t1 * t0\n"
          "return tau t0 t2 t2 0 -0 t0\n",
          6),
      "// link hip: velocity\n"
      "const Scalar t0 = q[0] + q[1];\n"
      "tau[0] = tau[5] = t0;\n"
      "tau[1] = tau[2] = q[0] * q[1] * t0;\n"
      "// constant elements\n"
      "tau[3] = tau[4] = Scalar(0.0);\n");
}

TEST(Lower, ElementsOfBothSignsShareADefinition) {
  EXPECT_EQ(
      lowered(
          "tmp t0 = q[0] - q[1]\n"
          "tmp t1 = q[0] - qd[0]\n"
          "return tau t0 -t0 -t1 -t1\n",
          4),
      "// link hip: velocity\n"
      "const Scalar t0 = q[0] - q[1];\n"
      "tau[0] = t0;\n"
      "tau[1] = -t0;\n"
      "tau[2] = tau[3] = qd[0] - q[0];\n");
}

TEST(Lower, ElementsThatAreInputsOrConstantsComeLast) {
  EXPECT_EQ(
      lowered("return tau -qd[1] 9.81 -9.81 qd[0]\n", 4),
      "tau[0] = -qd[1];\n"
      "tau[3] = qd[0];\n"
      "// constant elements\n"
      "tau[1] = Scalar(9.81);\n"
      "tau[2] = Scalar(-9.81);\n");
}

TEST(Lower, SinesThatAreElementsAreStored) {
  EXPECT_EQ(
      lowered(
          "tmp t0 = sin q[0]\n"
          "tmp t1 = cos q[0]\n"
          "return tau t1 t0 -t0 t1\n",
          4),
      "const auto [s_HFE, c_HFE] = robcogen::sincos(q[0]);\n"
      "// link hip: velocity\n"
      "tau[1] = s_HFE;\n"
      "tau[2] = -s_HFE;\n"
      "tau[0] = tau[3] = c_HFE;\n");
}

TEST(Lower, StatementsThatNothingNeedsAreLeftOut) {
  EXPECT_EQ(
      lowered("let unused = sin q[1]\n"
              "let also = unused + q[1]\n"
              "tmp t0 = q[0] + 1\n"
              "return tau t0\n"),
      "// link hip: velocity\n"
      "tau[0] = q[0] + Scalar(1.0);\n");
}

TEST(Lower, UnusedParametersAreMarked) {
  const Kernel kernel = lower(leg_program("return tau q[1]\n"), "leg");
  ASSERT_EQ(kernel.parameters.size(), 3u);
  EXPECT_TRUE(kernel.parameters[0].used);
  EXPECT_FALSE(kernel.parameters[1].used);
  EXPECT_TRUE(kernel.parameters[2].output);
  EXPECT_TRUE(kernel.parameters[2].used);
}

TEST(Lower, NamesThatTheTextNeedsItselfAreNotTaken) {
  EXPECT_EQ(
      lowered(test::described_program("program p\n"
                                      "input q joint_position class q\n"
                                      "output tau value 1 1\n"
                                      "section s \n"
                                      "in 0\n"
                                      "tmp t0 = sin q[0]\n"
                                      "tmp t1 = cos q[1]\n"
                                      "let q = t0 + t1\n"
                                      "let s_class = q + 1\n"
                                      "let Scalar = s_class * q\n"
                                      "let tau = Scalar * Scalar\n"
                                      "let double = tau + s_class\n"
                                      "let _x = double * tau\n"
                                      "let sincos = _x * double\n"
                                      "let major = _x / sincos\n"
                                      "let out = major + sincos\n"
                                      "return tau out\n")),
      "const Scalar s_class = sin(q[0]);\n"
      "const Scalar c_q = cos(q[1]);\n"
      "const Scalar q_2 = s_class + c_q;\n"
      "const Scalar s_class_2 = q_2 + Scalar(1.0);\n"
      "const Scalar Scalar_2 = s_class_2 * q_2;\n"
      "const Scalar tau_2 = Scalar_2 * Scalar_2;\n"
      "const Scalar double_ = tau_2 + s_class_2;\n"
      "const Scalar x = double_ * tau_2;\n"
      "const Scalar sincos_2 = x * double_;\n"
      "const Scalar major_ = x / sincos_2;\n"
      "tau[0] = major_ + sincos_2;\n");
}

// Continuation lines include their indentation.
bool fits_in_columns(const std::string& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  return end <= 118 && text.size() - end <= 121;
}

// A sum of `terms` products of inputs.
symbolic::Program long_sum(int terms) {
  std::string text;
  for (int k = 0; k < terms; ++k) {
    const std::string n = std::to_string(k);
    text += "tmp p" + n + " = q[" + std::to_string(k % 2) + "] * qd[" + std::to_string(k / 2 % 2) + "]\n";
    if (k == 0) continue;
    text += "tmp s" + n + " = " + (k == 1 ? "p0" : "s" + std::to_string(k - 1)) + " + p" + n + "\n";
  }
  return leg_program(text + "return tau s" + std::to_string(terms - 1) + "\n");
}

TEST(Lower, LinesThatDoNotFitAreSplitBesideTheirProducts) {
  EXPECT_EQ(
      lowered(long_sum(10)),
      "// link hip: velocity\n"
      "const Scalar s6 =\n"
      "      q[0] * qd[0] + q[1] * qd[0] + q[0] * qd[1] + q[1] * qd[1] + q[0] * qd[0] + q[1] * qd[0] + q[0] * qd[1];\n"
      "tau[0] = s6 + q[1] * qd[1] + q[0] * qd[0] + q[1] * qd[0];\n");
}

TEST(Lower, NoLineIsLongerThanAColumn) {
  for (int terms : {2, 7, 8, 9, 30, 200})
    for (const Line& line : lower(long_sum(terms), "p").lines) EXPECT_TRUE(fits_in_columns(text(line))) << text(line);
}

TEST(Lower, LongNamesAreShortened) {
  const std::string name(100, 'x');
  const Kernel kernel = lower(
      leg_program(
          "let " + name + "a = q[0] * 1.2345678901234567e-100\n" +  //
          "let " + name + "b = " + name + "a + " + name + "a\n" +   //
          "let " + name + "c = " + name + "a * " + name + "b\n" +   //
          "let out = " + name + "c / " + name + "b\nreturn tau out\n"),
      "leg");
  ASSERT_EQ(kernel.lines.size(), 5u);
  for (const Line& line : kernel.lines) EXPECT_LE(text(line).size(), 118u);
  EXPECT_NE(kernel.lines[1].targets[0], kernel.lines[2].targets[0]);
}

}  // namespace
}  // namespace robcogen::backend::cpp::lower_test
