// One program in place of several.
#include "symbolic/fuse.h"

#include "programs.h"
#include "symbolic/cost.h"

namespace robcogen::symbolic::fuse_test {
namespace {

using test::program;

// The inputs of both have other places in the fused program, and the product q[0] * q[1] is computed once.
TEST(Fuse, SharesInputsByNameAndEqualValues) {
  const Program first = program(
      "program first\n"
      "input gravity gravity x y z\n"
      "input q joint_position a b\n"
      "output tau joint_force 1 1\n"
      "section hip link hip\n"
      "in 0\n"
      "let p = q[0] * q[1]\n"
      "let t = p + gravity[2]\n"
      "return tau t\n");
  const Program second = program(
      "program second\n"
      "input qd joint_velocity a b\n"
      "input q joint_position a b\n"
      "output e energy 1 1\n"
      "section hip link hip\n"
      "in 0\n"
      "let p = q[0] * q[1]\n"
      "let e0 = p * qd[1]\n"
      "return e e0\n");
  const Program both = fused("both", {first, second});
  EXPECT_EQ(verify(both), "");
  ASSERT_EQ(both.inputs.size(), 3U);
  EXPECT_EQ(both.inputs[0].name, "q");
  EXPECT_EQ(both.inputs[1].name, "qd");
  EXPECT_EQ(both.inputs[2].name, "gravity");
  EXPECT_EQ(cost(both).mul, 2);
  EXPECT_EQ(cost(both).add, 1);
  const auto results = interpret<double>(both, {{"q", {2, 3}}, {"qd", {0, 5}}, {"gravity", {0, 0, -9}}});
  EXPECT_EQ(results.at("tau"), std::vector<double>{-3});
  EXPECT_EQ(results.at("e"), std::vector<double>{30});
  const Program outline = fused_outline("both", {first, second});
  EXPECT_EQ(outline.inputs.size(), 3U);
  EXPECT_EQ(outline.outputs.size(), 2U);
}

}  // namespace
}  // namespace robcogen::symbolic::fuse_test
