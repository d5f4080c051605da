// Small programs with equal limbs, in lanes.
#include "pass/lanes/pack_lanes.h"

#include <functional>

#include "symbolic/cost.h"
#include "symbolic/programs.h"

namespace robcogen::pass::pack_lanes_test {
namespace {

using symbolic::Op;
using symbolic::Program;
using symbolic::Statement;

// Two limbs with two joints each, on a trunk with two joints.
Program with(const std::string& statements, const std::string& returns, int outputs) {
  return test::program(
      "program test\n"
      "input q joint_position L_hip L_knee R_hip R_knee waist neck\n"
      "output out value " +
      std::to_string(outputs) +
      " 1\n"
      "section leg legs\n"
      "section trunk trunk\n"
      "in 0\n" +
      statements + "return out " + returns + "\n");
}
const std::vector<InputTuples> kLegs = {{{0, 2}, {1, 3}}};

std::vector<double> run(const Program& program) {
  return symbolic::interpret<double>(program, {{"q", {0.3, -1.1, 0.8, 0.7, 2.1, 0.4}}}).at("out");
}

int count_if(const Program& program, const std::function<bool(const Statement&)>& condition) {
  return static_cast<int>(std::count_if(program.statements.begin(), program.statements.end(), condition));
}

const std::string kTrunk = "in 1\ntmp t0 = q[4] * q[5]\ntmp t1 = t0 + 0.5\ntmp t2 = t1 / q[4]\ntmp t3 = sqrt t1\n";

TEST(PackLanes, OneStatementServesAllLimbs) {
  const Program program =
      with("tmp L_a = q[0] * q[1]\ntmp R_a = q[2] * q[3]\ntmp L_b = L_a + q[0]\ntmp R_b = R_a + q[2]\n", "L_b R_b", 2);
  const Program lanes = packed(program, kLegs);
  EXPECT_EQ(symbolic::verify(lanes), "");
  EXPECT_EQ(run(lanes), run(program));
  const symbolic::Cost c = symbolic::cost(lanes);
  EXPECT_EQ(std::pair(c.mul, c.add), std::pair(1, 1));
}

// The trunk's terms are ready long before the limbs' sum, after which only one addition remains.
TEST(PackLanes, ASumOfLanesComesLast) {
  const Program program = with(
      "tmp L_a = q[0] * q[1]\ntmp R_a = q[2] * q[3]\ntmp L_b = L_a * q[0]\ntmp R_b = R_a * q[2]\n"
      "in 1\ntmp t0 = q[4] * q[5]\ntmp t1 = q[4] * 0.5\ntmp t2 = q[5] * 0.25\n"
      "tmp s0 = L_b + R_b\ntmp s1 = s0 + t0\ntmp s2 = s1 + t1\ntmp s3 = s2 + t2\n",
      "s3", 1);
  const Program lanes = packed(program, kLegs);
  ASSERT_TRUE(lanes.has_lanes());
  constexpr double kRounding = 1e-15;  // a few additions of numbers below 3, in a different order
  EXPECT_NEAR(run(lanes)[0], run(program)[0], kRounding);
  const Statement& last = lanes.statements.back();
  ASSERT_TRUE(is_sum(last.op));
  const auto is_sum_of_lanes = [&](const symbolic::Operand& o) {
    return is_statement(o) && lanes.statements[static_cast<std::size_t>(o.index)].op == Op::sum_lanes;
  };
  EXPECT_TRUE(is_sum_of_lanes(last.a) || is_sum_of_lanes(last.b)) << symbolic::print(lanes);
}

// Signs of single operands, in one limb or in both: factors, dividends, divisors, angles.
TEST(PackLanes, OperandsKeepTheirSigns) {
  const Program program = with(
      "tmp L_a = q[0] * q[1]\ntmp R_a = q[2] * -q[3]\ntmp L_b = -L_a * q[0]\ntmp R_b = R_a * -q[2]\n"
      "tmp L_c = L_b / -L_a\ntmp R_c = R_b / R_a\ntmp L_s = sin -L_c\ntmp R_s = sin R_c\n"
      "tmp L_t = sin -L_s\ntmp R_t = sin -R_s\ntmp L_u = cos -L_t\ntmp R_u = cos R_t\n",
      "L_b R_b L_c R_c L_s R_s L_t R_t L_u R_u", 10);
  const Program lanes = packed(program, kLegs);
  EXPECT_EQ(symbolic::verify(lanes), "");
  EXPECT_TRUE(lanes.has_lanes());
  EXPECT_EQ(run(lanes), run(program)) << symbolic::print(lanes);
}

// A plus in one limb is a minus in the other: the numbers absorb the signs, and no instruction changes the sign of a
// lane.
TEST(PackLanes, NumbersTakeTheSignsOfMirroredLimbs) {
  const Program program =
      with("tmp L_a = q[0] * 0.5\ntmp R_a = q[2] * 0.5\ntmp L_b = q[1] + L_a\ntmp R_b = q[3] - R_a\n", "L_b R_b", 2);
  const Program lanes = packed(program, kLegs);
  EXPECT_EQ(run(lanes), run(program));
  const symbolic::Cost c = symbolic::cost(lanes);
  EXPECT_EQ(std::pair(c.mul, c.add), std::pair(1, 1));
  bool has_signs = false;
  for (const Statement& s : lanes.statements)
    if (s.op == Op::gather) has_signs = has_signs || s.lanes[0].negative != s.lanes[1].negative;
  EXPECT_TRUE(has_signs);
}

// If there is no number, a product with ones and minus ones changes the signs.
TEST(PackLanes, ElseAProductTurnsSigns) {
  const Program program =
      with("tmp L_a = q[0] * q[1]\ntmp R_a = q[2] * q[3]\ntmp L_b = q[1] + L_a\ntmp R_b = q[3] - R_a\n", "L_b R_b", 2);
  const Program lanes = packed(program, kLegs);
  EXPECT_EQ(run(lanes), run(program));
  EXPECT_EQ(symbolic::cost(lanes).mul, 2);
}

// The trunk is computed as without lanes.
TEST(PackLanes, WhatNoLimbEntersKeepsItsOperations) {
  const std::string legs = "tmp L_a = q[0] * q[1]\ntmp R_a = q[2] * q[3]\n";
  const Program alone = with(kTrunk, "t2 t3", 2), both = with(legs + kTrunk, "L_a R_a t2 t3", 4);
  const Program lanes = packed(both, kLegs);
  EXPECT_EQ(run(lanes), run(both));
  for (const Op op : {Op::add, Op::multiply, Op::divide, Op::square_root}) {
    const auto is_scalar_op = [&](const Statement& s) { return s.op == op && s.width == 1; };
    EXPECT_EQ(count_if(lanes, is_scalar_op), count_if(alone, is_scalar_op));
  }
}

TEST(PackLanes, NoLimbsNoLanes) {
  const Program program = with("tmp L_a = q[0] * q[1]\ntmp R_a = q[2] * q[3]\n", "L_a R_a", 2);
  const Packed result = pack_lanes(program, {});
  EXPECT_TRUE(result.in_lanes.empty());
  EXPECT_EQ(symbolic::print(result.program), symbolic::print(program));
}

// Bringing one product into lanes costs more than it saves.
TEST(PackLanes, WhatGainsNothingStays) {
  const Program program = with("tmp L_a = q[0] * q[1]\ntmp R_a = q[2] * q[3]\n", "L_a R_a", 2);
  const Packed result = pack_lanes(program, kLegs);
  EXPECT_EQ(result.in_lanes, std::vector<bool>{false});
  EXPECT_EQ(symbolic::print(result.program), symbolic::print(program));
}

// With many factors in each limb, lanes are faster. Programs in lanes are not packed again.
TEST(PackLanes, IsIdempotent) {
  constexpr int kFactors = 32;
  std::string statements;
  for (const auto& [limb, hip] : {std::pair("L", "q[0]"), std::pair("R", "q[2]")}) {
    const auto name = [limb = std::string(limb)](int k) { return limb + "_t" + std::to_string(k); };
    for (int k = 0; k < kFactors; ++k)
      statements += "tmp " + name(k) + " = " + hip + (" + " + std::to_string(k + 2)) + "\n";
    for (int k = kFactors; k < 2 * kFactors - 1; ++k)
      statements += "tmp " + name(k) + " = " + name(2 * (k - kFactors)) + " * " + name(2 * (k - kFactors) + 1) + "\n";
  }
  const Program program = with(statements, "L_t62 R_t62", 2);
  const Packed once = pack_lanes(program, kLegs);
  EXPECT_EQ(once.in_lanes, std::vector<bool>{true});
  EXPECT_EQ(2 * symbolic::cost(once.program).instructions, symbolic::cost(program).instructions);
  const Packed twice = pack_lanes(once.program, kLegs);
  EXPECT_EQ(twice.in_lanes, std::vector<bool>{false});
  EXPECT_EQ(symbolic::print(twice.program), symbolic::print(once.program));
}

}  // namespace
}  // namespace robcogen::pass::pack_lanes_test
