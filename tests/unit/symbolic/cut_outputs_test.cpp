// Stages in turn, and those on demand at the earliest time, compute what the whole program computes, to the last bit.
#include "symbolic/cut_outputs.h"

#include <limits>

#include "run_stage.h"
#include "support/index.h"

namespace robcogen::symbolic::cut_outputs_test {
namespace {

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

TEST(CutOutputs, ChangesNoBitWheneverAStageOnDemandRuns) {
  int passed = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    test::RandomPrograms random(seed);
    const Program whole = random.make();
    const Arrays<double> inputs{{"a", random.inputs()}};
    // Elements alternate: two stages in turn, and one on demand after each of them.
    std::vector<OutputElements> in_turn(2);
    std::vector<StageOnDemand> on_demand(2);
    for (int after = 0; after < 2; ++after) on_demand[at(after)].after = after;
    int next = 0;
    for (int output = 0; output < static_cast<int>(whole.outputs.size()); ++output)
      for (int k = 0; k < static_cast<int>(whole.outputs[at(output)].values.size()); ++k, ++next)
        (next % 2 == 0 ? in_turn[at(next / 2 % 2)] : on_demand[at(next / 2 % 2)].elements).push_back({output, k});
    const Stages stages = cut_outputs(whole, in_turn, on_demand);
    ASSERT_EQ(stages.list.size(), 4u);
    passed += stages.workspace;
    Arrays<double> all = inputs;
    for (const OutputArray& output : whole.outputs) all[output.name].assign(output.values.size(), kUnset);
    all[kWorkspace].assign(at(stages.workspace), kUnset);
    for (const std::size_t stage : {0u, 2u, 1u, 3u}) test::run_stage(stages.list[stage].program, all);
    for (const auto& [name, values] : interpret<double>(whole, inputs))
      ASSERT_EQ(all.at(name), values) << "seed " << seed << "\n" << print(whole);
  }
  EXPECT_GT(passed, 50);
}

// What only the stage on demand reads is computed there; what it shares with a later stage in turn is computed before.
TEST(CutOutputs, LeavesToAStageWhatNoOtherReads) {
  const Program whole = test::small_program(
      "tmp x = a[0] * a[1]\ntmp shared = x + a[2]\ntmp own = x * a[3]\ntmp sum = own + shared\ntmp last = shared * x\n"
      "return out x sum last\n",
      3);
  const Stages stages = cut_outputs(whole, {{{0, 0}}, {{0, 2}}}, {{{{0, 1}}, 0}});
  ASSERT_EQ(stages.list.size(), 3u);
  EXPECT_EQ(stages.list[0].program.statements.size(), 2u);  // x, shared
  EXPECT_EQ(stages.list[1].program.statements.size(), 1u);  // last
  EXPECT_EQ(stages.list[2].program.statements.size(), 2u);  // own, sum
  EXPECT_EQ(stages.workspace, 2);
}

}  // namespace
}  // namespace robcogen::symbolic::cut_outputs_test
