// Sums of lanes in pairs: only the order of statements changes.
#include "pass/pair_sums.h"

#include "symbolic/programs.h"

namespace robcogen::pass::pair_sums_test {
namespace {

using symbolic::Program;

Program with(const std::string& statements, const std::string& returns, int outputs) {
  return test::small_program("in 0\n" + statements + "return out " + returns + "\n", outputs);
}

// The names in their order; capitals name sums of lanes.
std::string order(const Program& program) {
  std::string result;
  for (const symbolic::Statement& s : program.statements) result += (result.empty() ? "" : " ") + s.name;
  return result;
}

std::vector<double> run(const Program& program) {
  return symbolic::interpret<double>(program, {{"a", {0.3, -1.1, 0.8, 0.7}}}).at("out");
}

void expect_order(const Program& program, const std::string& expected) {
  const Program paired = pair_sums(program);
  EXPECT_EQ(symbolic::verify(paired), "");
  EXPECT_EQ(order(paired), expected);
  EXPECT_EQ(run(paired), run(program));
}

TEST(PairSums, TheSecondIsFoundWithTheFirst) {
  expect_order(
      with(
          "tmp x = gather a[0] a[1]\n"
          "tmp F = sum_lanes x\n"
          "tmp u = F * a[2]\n"
          "tmp y = x * x\n"
          "tmp G = sum_lanes y\n"
          "tmp v = G + u\n",
          "u v", 2),
      "x y F G u v");
}

TEST(PairSums, OneThatNeedsAnotherIsNotItsPartner) {
  expect_order(
      with(
          "tmp x = gather a[0] a[1]\n"
          "tmp F = sum_lanes x\n"
          "tmp y = x * F\n"
          "tmp G = sum_lanes y\n"
          "tmp z = x + x\n"
          "tmp H = sum_lanes z\n",
          "F G H", 3),
      "x z F H y G");
}

// Sums of four lanes and of two lanes take different instructions.
TEST(PairSums, PartnersHaveTheSameNumberOfLanes) {
  expect_order(
      with(
          "tmp x = gather a[0] a[1]\n"
          "tmp F = sum_lanes x\n"
          "tmp y = gather a[0] a[1] a[2] a[3]\n"
          "tmp G = sum_lanes y\n",
          "F G", 2),
      "x F y G");
}

TEST(PairSums, ThoseOfOneSectionComeFirstThenWhatIsLeft) {
  expect_order(
      with(
          "tmp x = gather a[0] a[1]\n"
          "tmp F = sum_lanes x\n"
          "in 1\n"
          "tmp y = x * x\n"
          "tmp G = sum_lanes y\n"
          "tmp z = y * x\n"
          "tmp H = sum_lanes z\n"
          "in 0\n"
          "tmp w = z * x\n"
          "tmp I = sum_lanes w\n",
          "F G H I", 4),
      "x y z w F I G H");
  expect_order(
      with(
          "tmp x = gather a[0] a[1]\n"
          "tmp F = sum_lanes x\n"
          "in 1\n"
          "tmp y = x * x\n"
          "tmp G = sum_lanes y\n",
          "F G", 2),
      "x y F G");
}

}  // namespace
}  // namespace robcogen::pass::pair_sums_test
