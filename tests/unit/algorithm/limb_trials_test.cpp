// Limb trials: each is traced once, has the weight of its program, and is judged by its loss of digits.
#include "algorithm/search/limb_trials.h"

#include "algorithm/dynamics/dynamics.h"
#include "random_robots.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm::limb_trials_test {
namespace {

using namespace test;
using model::Quantity;

TEST(Trials, WeighTheSameFramesOnce) {
  Trials trials;
  int weighed = 0;
  const auto work_in = [&](double turn, Quantity slide) {
    const auto weigh = [&] { return symbolic::TracedCost{.work = ++weighed}; };
    return trials.in_frames({{}, {Quantity(turn), std::move(slide)}}, weigh).cost.work;
  };
  EXPECT_EQ(work_in(0.5, Quantity(0.0)), 1);
  EXPECT_EQ(work_in(0.5, Quantity(0.0)), 1);
  EXPECT_EQ(work_in(0.25, Quantity(0.0)), 2);
  EXPECT_EQ(work_in(0.5, Quantity(0.125)), 3);
  EXPECT_EQ(work_in(0.5, Quantity(0.0)), 1);
}

class LimbTrialsOf : public testing::TestWithParam<int> {
 protected:
  static constexpr int kJoints = 6;
  Numbers n{static_cast<unsigned>(GetParam())};
  model::KinematicTree tree = random_robot(n, kJoints, false);
  Formulation formulation;
  TraceOf trace = [](Trace& t, const Formulation& f) { trace_newton_euler(t, Loads::standard_gravity, f); };
  LimbTrials trials{tree, formulation, trace, nullptr};
};

TEST_P(LimbTrialsOf, WeighAsTheProgramDoes) {
  LinkFrames frames(kJoints);
  for (LinkFrame& frame : frames)
    frame = {Quantity(n.pick(2) == 0 ? 0.0 : n.real()), Quantity(n.pick(2) == 0 ? 0.0 : n.real()), n.pick(2) == 0};
  for (int joint = 0; joint < kJoints; ++joint) {
    const LimbView view = limb_view(tree, joint);
    Formulation own;
    for (const int j : view.joints) own.frames.push_back(frames[static_cast<std::size_t>(j)]);
    own.is_draft = true;
    const symbolic::Program program = newton_euler(view.tree, "tau", Loads::standard_gravity, own);
    const symbolic::TracedCost& cost = trials.of(joint, frames).cost;
    EXPECT_EQ(cost.work, symbolic::work(program)) << joint;
    EXPECT_EQ(cost.statements, static_cast<long>(program.statements.size())) << joint;
  }
}

TEST_P(LimbTrialsOf, FramesFarAwayLoseDigits) {
  const LinkFrames near(kJoints);
  LinkFrames far(kJoints);
  for (LinkFrame& frame : far) frame.slide = Quantity(1e7);
  for (int joint = 0; joint < kJoints; ++joint)
    EXPECT_TRUE(trials.keeps_digits(joint, near, trials.of(joint, near))) << joint;
  int lost = 0;
  for (int joint = 0; joint < kJoints; ++joint) lost += trials.keeps_digits(joint, far, trials.of(joint, far)) ? 0 : 1;
  EXPECT_GT(lost, 0);
}

INSTANTIATE_TEST_SUITE_P(, LimbTrialsOf, testing::Range(0, 4));

}  // namespace
}  // namespace robcogen::algorithm::limb_trials_test
