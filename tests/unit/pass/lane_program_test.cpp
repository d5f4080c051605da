// Programs with lanes, built from plans, give the same results with fewer statements.
#include "pass/lanes/lane_program.h"

#include "pass/lanes/plan_signs.h"
#include "symbolic/cost.h"
#include "two_limbs.h"

namespace robcogen::pass::lane_program_test {
namespace {

using namespace two_limbs;
using symbolic::Op;

Program with_lanes(const Program& p) {
  LaneBuilder builder(p);
  const std::optional<LanePlan> plan = lane_plan(p, kLimbs, builder.constant(Number()));
  EXPECT_TRUE(plan);
  return plan ? lane_program(p, *plan, plan_signs(*plan), builder) : p;
}

int count(const Program& p, Op op, int width) {
  return static_cast<int>(std::count_if(p.statements.begin(), p.statements.end(), [&](const symbolic::Statement& s) {
    return s.op == op && s.width == width;
  }));
}

TEST(LanePrograms, ComputeWhatTheLimbsDid) {
  int in_lanes = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Program p = RandomLimbs(seed).make();
    LaneBuilder builder(p);
    const std::optional<LanePlan> plan = lane_plan(p, kLimbs, builder.constant(Number()));
    if (!plan) continue;
    const Program lanes = lane_program(p, *plan, plan_signs(*plan), builder);
    ASSERT_EQ(verify(lanes), "") << print(p) << print(lanes);
    ASSERT_EQ(robcogen::test::difference(p, lanes, kInputs), "") << print(p) << print(lanes);
    in_lanes += lanes.has_lanes();
  }
  EXPECT_GT(in_lanes, 400);
}

TEST(LanePrograms, HaveOneStatementForBothLimbs) {
  const Program lanes = with_lanes(limbs_program(
      "tmp L_a = a[0] * a[1]\ntmp R_a = a[2] * a[3]\ntmp L_b = sin L_a\ntmp R_b = sin R_a\n", "L_b R_b", 2));
  EXPECT_EQ(count(lanes, Op::multiply, 2), 1);
  EXPECT_EQ(count(lanes, Op::sine, 2), 1);
  EXPECT_EQ(count(lanes, Op::multiply, 1) + count(lanes, Op::sine, 1), 0);
  // The output reads the lanes directly.
  ASSERT_EQ(lanes.outputs[0].values.size(), 2U);
  EXPECT_EQ(lanes.outputs[0].values[0].lane, 0);
  EXPECT_EQ(lanes.outputs[0].values[1].lane, 1);
}

// Numbers become a vector if they differ, and a scalar if they do not.
TEST(LanePrograms, HaveVectorsOfNumbers) {
  const auto gathers_of_numbers = [](const Program& p) {
    return std::count_if(p.statements.begin(), p.statements.end(), [](const symbolic::Statement& s) {
      return s.op == Op::gather && std::all_of(s.lanes.begin(), s.lanes.end(), symbolic::is_constant);
    });
  };
  const auto limbs = [](const std::string& left, const std::string& right) {
    return with_lanes(limbs_program(
        "tmp L_a = a[0] * " + left + "\ntmp R_a = a[2] * " + right + "\ntmp L_b = L_a + a[1]\ntmp R_b = R_a + a[3]\n",
        "L_b R_b", 2));
  };
  EXPECT_EQ(gathers_of_numbers(limbs("0.5", "0.25")), 1);
  EXPECT_EQ(gathers_of_numbers(limbs("0.5", "-0.5")), 1);
  EXPECT_EQ(gathers_of_numbers(limbs("0.5", "0.5")), 0);
}

TEST(LanePrograms, AddUpLanesWhereATrunkDoes) {
  const Program lanes = with_lanes(
      limbs_program("tmp L_a = a[0] * a[1]\ntmp R_a = a[2] * a[3]\ntmp s0 = L_a + R_a\ntmp s1 = s0 + a[4]\n", "s1", 1));
  EXPECT_EQ(count(lanes, Op::sum_lanes, 1), 1);
  EXPECT_EQ(count(lanes, Op::multiply, 2), 1);
}

TEST(LanePrograms, NamesAreWhatTheLimbsHaveInCommon) {
  const Program lanes =
      with_lanes(limbs_program("let L_force = a[0] * a[1]\nlet R_force = a[2] * a[3]\n", "L_force R_force", 2));
  const auto product = std::find_if(lanes.statements.begin(), lanes.statements.end(), [](const symbolic::Statement& s) {
    return s.op == Op::multiply;
  });
  ASSERT_NE(product, lanes.statements.end());
  ASSERT_TRUE(product->quantity);
  EXPECT_EQ(text(*product->quantity), "force");
}

}  // namespace
}  // namespace robcogen::pass::lane_program_test
