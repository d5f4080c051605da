// The steps of a run: what each name switches on.
#include "driver/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "pass/passes.h"

namespace robcogen::driver::steps_test {
namespace {

using Names = std::vector<std::string>;

TEST(Steps, AreChoicesPassesAndLanesInThisOrder) {
  Names expected = algorithm::choices();
  for (const std::string& pass : pass::names()) expected.push_back(pass);
  expected.push_back("lanes");
  EXPECT_EQ(all_steps(), expected);
  EXPECT_EQ(std::set<std::string>(expected.begin(), expected.end()).size(), expected.size());
}

TEST(Steps, AreAllTakenUnlessSaidOtherwise) {
  const Steps all;
  const algorithm::Formulation f = all.formulation();
  EXPECT_TRUE(
      f.base_parameters && f.choose_forward_dynamics && f.choose_frames && f.turn_inertia && f.choose_reverse_mode);
  EXPECT_EQ(f.effort, 1);
  EXPECT_EQ(all.passes(), pass::names());
  EXPECT_TRUE(all.has_lanes());
}

TEST(Steps, WithoutNamesAreThePlainFormulationAlone) {
  const Steps none{{}, 3};
  const algorithm::Formulation f = none.formulation(), plain = algorithm::plain_formulation();
  EXPECT_EQ(f.base_parameters, plain.base_parameters);
  EXPECT_EQ(f.choose_forward_dynamics, plain.choose_forward_dynamics);
  EXPECT_EQ(f.choose_frames, plain.choose_frames);
  EXPECT_EQ(f.turn_inertia, plain.turn_inertia);
  EXPECT_EQ(f.choose_reverse_mode, plain.choose_reverse_mode);
  EXPECT_EQ(f.effort, 3);
  EXPECT_TRUE(none.passes().empty());
  EXPECT_FALSE(none.has_lanes());
}

// Each name switches on exactly one step.
TEST(Steps, AreSwitchedOneByOne) {
  for (const std::string& name : all_steps()) {
    const Steps one{{name}};
    const algorithm::Formulation f = one.formulation();
    const int on = f.base_parameters + f.choose_forward_dynamics + f.choose_frames + f.turn_inertia +
                   f.choose_reverse_mode + one.has_lanes() + static_cast<int>(one.passes().size());
    EXPECT_EQ(on, 1) << name;
    const bool is_pass = std::count(pass::names().begin(), pass::names().end(), name) > 0;
    EXPECT_EQ(one.passes(), is_pass ? Names{name} : Names());
  }
  EXPECT_TRUE((Steps{{"base-parameters"}}).formulation().base_parameters);
  EXPECT_TRUE((Steps{{"lanes"}}).has_lanes());
}

}  // namespace
}  // namespace robcogen::driver::steps_test
