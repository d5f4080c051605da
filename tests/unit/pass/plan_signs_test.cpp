// The signs with which the values of lanes are kept: for plans written by hand, and for random mirrored limbs.
#include "pass/lanes/plan_signs.h"

#include "pass/lanes/lane_program.h"
#include "symbolic/cost.h"
#include "two_limbs.h"

namespace robcogen::pass::plan_signs_test {
namespace {

using namespace two_limbs;
using Kind = PackedValue::Kind;
using symbolic::Op;

// A plan of values in two lanes, each built from its parts.
class PlanOf {
 public:
  int leaf(Kind kind = Kind::gather) { return add(kind, Op::add, {}); }
  int make(Op op, std::vector<Part> parts) {
    return add(is_sum(op) ? Kind::sum : Kind::operation, op, std::move(parts));
  }
  void ask_for(Part root) { plan_.roots.push_back(root); }
  std::vector<unsigned> signs() const { return plan_signs(plan_); }

 private:
  LanePlan plan_;

  int add(Kind kind, Op op, std::vector<Part> parts) {
    PackedValue w;
    w.kind = kind;
    w.width = 2;
    w.op = op;
    w.parts = std::move(parts);
    plan_.order.push_back(static_cast<int>(plan_.packed_values.size()));
    plan_.packed_values.push_back(std::move(w));
    return plan_.order.back();
  }
};

constexpr unsigned kSecond = 0b10;

// Removes a common sign of both lanes, which costs nothing.
unsigned in_second_lane(unsigned signs) {
  return signs & 1U ? signs ^ 0b11U : signs;
}

// k * x + y in one limb, k * x - y in the other: the number absorbs the sign.
TEST(PlanSigns, NumbersTakeThem) {
  PlanOf plan;
  const int x = plan.leaf(), y = plan.leaf(), k = plan.leaf(Kind::numbers);
  const int square = plan.make(Op::multiply, {{y}, {y}});  // its sign is not free
  const int product = plan.make(Op::multiply, {{x}, {k}});
  plan.make(Op::add, {{square}, {product, kSecond}});
  const std::vector<unsigned> signs = plan.signs();
  EXPECT_EQ(in_second_lane(signs[static_cast<std::size_t>(product)]), kSecond);
  EXPECT_EQ(in_second_lane(signs[static_cast<std::size_t>(square)]), 0U);
}

// If there is no number, an input absorbs the sign, because it is brought into lanes anyway.
TEST(PlanSigns, ElseInputsTakeThem) {
  PlanOf plan;
  const int x = plan.leaf(), y = plan.leaf();
  const int sum = plan.make(Op::add, {{x}, {y, kSecond}});
  const std::vector<unsigned> signs = plan.signs();
  // Both terms have the same signs in the sum, and the sum has them, too.
  const auto of = [&](int w) { return signs[static_cast<std::size_t>(w)]; };
  EXPECT_EQ(in_second_lane(of(x) ^ of(y)), kSecond);
  EXPECT_EQ(in_second_lane(of(sum) ^ of(x)), 0U);
}

TEST(PlanSigns, OfProductsAreThoseOfTheFactors) {
  PlanOf plan;
  const int x = plan.leaf(), y = plan.leaf();
  const int product = plan.make(Op::multiply, {{x, kSecond}, {y}});
  const int sine = plan.make(Op::sine, {{product}});
  const std::vector<unsigned> signs = plan.signs();
  const auto of = [&](int w) { return signs[static_cast<std::size_t>(w)]; };
  EXPECT_EQ(in_second_lane(of(product) ^ of(x) ^ of(y)), kSecond);
  EXPECT_EQ(in_second_lane(of(sine)), in_second_lane(of(product)));  // sine is an odd function
}

TEST(PlanSigns, RadicandsHaveNone) {
  PlanOf plan;
  const int x = plan.leaf(), k = plan.leaf(Kind::numbers);
  const int radicand = plan.make(Op::multiply, {{x}, {k}});
  plan.make(Op::square_root, {{radicand, kSecond}});
  EXPECT_EQ(in_second_lane(plan.signs()[static_cast<std::size_t>(radicand)]), kSecond);
}

TEST(PlanSigns, OutputsGetTheirOwn) {
  PlanOf plan;
  const int x = plan.leaf(), k = plan.leaf(Kind::numbers);
  const int product = plan.make(Op::multiply, {{x}, {k}});
  plan.ask_for({product, kSecond});
  EXPECT_EQ(in_second_lane(plan.signs()[static_cast<std::size_t>(product)]), kSecond);
}

// Sums and products can be computed with any signs. For mirrored limbs, the planned signs cost less on the whole than
// changing each sign where it occurs; not always, because each choice is made once.
TEST(PlanSigns, SaveChanges) {
  int planned = 0, unplanned = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Program p = RandomLimbs(seed).mirrored();
    LaneBuilder builder(p), unplanned_builder(p);
    const Operand zero = builder.constant(Number());
    ASSERT_EQ(unplanned_builder.constant(Number()), zero);
    const std::optional<LanePlan> plan = lane_plan(p, kLimbs, zero);
    ASSERT_TRUE(plan);
    const std::vector<unsigned> no_signs(plan->packed_values.size(), 0U);
    const Program with = lane_program(p, *plan, plan_signs(*plan), builder);
    const Program without = lane_program(p, *plan, no_signs, unplanned_builder);
    ASSERT_EQ(robcogen::test::difference(p, with, kInputs), "") << print(p) << print(with);
    ASSERT_EQ(robcogen::test::difference(p, without, kInputs), "") << print(p) << print(without);
    planned += symbolic::cost(with).mul;
    unplanned += symbolic::cost(without).mul;
  }
  EXPECT_LT(10 * planned, 9 * unplanned);
}

}  // namespace
}  // namespace robcogen::pass::plan_signs_test
