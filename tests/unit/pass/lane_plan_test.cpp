// The plan for lanes: which values the limbs compute together, and in which order.
#include "pass/lanes/lane_plan.h"

#include <set>

#include "symbolic/cost.h"
#include "two_limbs.h"

namespace robcogen::pass::lane_plan_test {
namespace {

using namespace two_limbs;
using Kind = PackedValue::Kind;

LanePlan plan_of(const Program& program) {
  const std::optional<LanePlan> plan = lane_plan(program, kLimbs, zero_of(program));
  EXPECT_TRUE(plan);
  return plan.value_or(LanePlan());
}

// Counts the packed values of a kind.
int count(const LanePlan& plan, Kind kind) {
  return static_cast<int>(std::count_if(
      plan.packed_values.begin(), plan.packed_values.end(), [&](const PackedValue& w) { return w.kind == kind; }));
}

// Operands come before their users, and everything occurs once.
void expect_sound(const Program& program, const LanePlan& plan) {
  std::set<int> known;
  const auto expect_known = [&](int node, int user) { EXPECT_TRUE(known.contains(node)) << node << " of " << user; };
  const auto expect_operand = [&](const Operand& o, int user) {
    if (is_statement(o)) expect_known(o.index, user);
  };
  for (const int node : plan.order) {
    if (node < plan.scalar_count()) {
      const LanePlan::Scalar& scalar = plan.scalars[static_cast<std::size_t>(node)];
      if (scalar.packed_value >= 0) {
        expect_known(plan.scalar_count() + scalar.packed_value, node);
      } else if (scalar.sum) {
        for (const int w : scalar.sum->packed_values) expect_known(plan.scalar_count() + w, node);
        for (const Operand& o : scalar.sum->rest) expect_operand(o, node);
      } else {
        for_each_operand(
            program.statements[static_cast<std::size_t>(node)], [&](const Operand& o) { expect_operand(o, node); });
      }
    } else {
      const PackedValue& w = plan.packed_values[static_cast<std::size_t>(node - plan.scalar_count())];
      for (const Part& part : w.parts) expect_known(plan.scalar_count() + part.packed_value, node);
      if (w.kind == Kind::gather || w.kind == Kind::broadcast)
        for (const Operand& o : w.lanes) expect_operand(o, node);
    }
    EXPECT_TRUE(known.insert(node).second) << node;
  }
}

TEST(LanePlans, LimbsComputeTogether) {
  const Program p = limbs_program(
      "tmp L_a = a[0] * 0.5\ntmp R_a = a[2] * 0.25\ntmp L_b = sin L_a\ntmp R_b = sin R_a\n", "L_b R_b", 2);
  const LanePlan plan = plan_of(p);
  expect_sound(p, plan);
  EXPECT_EQ(count(plan, Kind::operation), 2);  // product and sine
  EXPECT_EQ(count(plan, Kind::gather), 1);     // of the inputs
  EXPECT_EQ(count(plan, Kind::numbers), 1);
  for (const PackedValue& w : plan.packed_values) EXPECT_EQ(w.width, 2);
  ASSERT_EQ(plan.roots.size(), 1U);
  const PackedValue& root = plan.packed_values[static_cast<std::size_t>(plan.roots[0].packed_value)];
  EXPECT_EQ(root.op, symbolic::Op::sine);
  EXPECT_EQ(root.lanes[0].index, 2);
  EXPECT_EQ(root.lanes[1].index, 3);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_GE(plan.scalars[s].packed_value, 0);
    EXPECT_EQ(plan.scalars[s].lane, static_cast<int>(s % 2));
  }
}

// The value of the trunk is the same for both limbs.
TEST(LanePlans, WhatLimbsShareIsScalar) {
  const Program p = limbs_program("tmp t = a[4] * a[5]\ntmp L_a = a[0] * t\ntmp R_a = a[2] * t\n", "L_a R_a", 2);
  const LanePlan plan = plan_of(p);
  expect_sound(p, plan);
  EXPECT_EQ(count(plan, Kind::broadcast), 1);
  EXPECT_TRUE(plan.scalars[0].needed);
  EXPECT_EQ(plan.scalars[0].packed_value, -1);
}

// Terms of both limbs in a sum of the trunk: the lanes are summed there.
TEST(LanePlans, ASumOverLimbsIsASumOfLanes) {
  const Program p =
      limbs_program("tmp L_a = a[0] * a[1]\ntmp R_a = a[2] * a[3]\ntmp s0 = L_a - R_a\ntmp s1 = s0 + a[4]\n", "s1", 1);
  const LanePlan plan = plan_of(p);
  expect_sound(p, plan);
  ASSERT_TRUE(plan.scalars[3].sum);
  ASSERT_EQ(plan.scalars[3].sum->packed_values.size(), 1U);
  ASSERT_EQ(plan.scalars[3].sum->rest.size(), 1U);
  EXPECT_EQ(plan.scalars[3].sum->rest[0].index, 4);
  const PackedValue& terms = plan.packed_values[static_cast<std::size_t>(plan.scalars[3].sum->packed_values[0])];
  EXPECT_EQ(terms.kind, Kind::sum);
  EXPECT_TRUE(terms.lanes.empty());
  ASSERT_EQ(terms.parts.size(), 1U);
  EXPECT_EQ(terms.parts[0].negated_lanes, 0b10U);
}

TEST(LanePlans, SignsOfLanesAreFlips) {
  const Program p = limbs_program("tmp L_a = a[0] * a[1]\ntmp R_a = a[2] * -a[3]\n", "L_a -R_a", 2);
  const LanePlan plan = plan_of(p);
  ASSERT_EQ(plan.roots.size(), 1U);
  EXPECT_EQ(plan.roots[0].negated_lanes, 0b10U);
  const PackedValue& root = plan.packed_values[static_cast<std::size_t>(plan.roots[0].packed_value)];
  ASSERT_EQ(root.parts.size(), 2U);
  EXPECT_EQ(root.parts[0].negated_lanes ^ root.parts[1].negated_lanes, 0b10U);
}

// A limb with fewer terms is filled up with zeros.
TEST(LanePlans, ShorterLimbsAreFilledUp) {
  const Program p = limbs_program(
      "tmp L_a = a[0] * a[1]\ntmp R_a = a[2] * a[3]\ntmp L_b = L_a + a[0]\ntmp R_b = R_a + a[2]\n"
      "tmp L_c = L_b + 0.5\ntmp L_d = sin L_c\ntmp R_d = sin R_b\n",
      "L_d R_d", 2);
  const LanePlan plan = plan_of(p);
  expect_sound(p, plan);
  const auto with_zero = [&](const PackedValue& w) {
    return w.kind == Kind::numbers && std::find(w.lanes.begin(), w.lanes.end(), zero_of(p)) != w.lanes.end();
  };
  EXPECT_TRUE(std::any_of(plan.packed_values.begin(), plan.packed_values.end(), with_zero));
}

// The sine comes before the cosine in one limb and after it in the other, so neither pair can come first.
TEST(LanePlans, ValuesThatWaitForEachOtherHaveNone) {
  const Program p = limbs_program(
      "tmp L_a = sin a[0]\ntmp L_b = cos L_a\ntmp R_b = cos a[2]\ntmp R_a = sin R_b\n", "L_a L_b R_a R_b", 4);
  EXPECT_FALSE(lane_plan(p, kLimbs, zero_of(p)));
}

TEST(LanePlans, RandomLimbsAreSoundlyPlanned) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const Program p = RandomLimbs(seed).make();
    const std::optional<LanePlan> plan = lane_plan(p, kLimbs, zero_of(p));
    if (plan) expect_sound(p, *plan);
  }
}

}  // namespace
}  // namespace robcogen::pass::lane_plan_test
