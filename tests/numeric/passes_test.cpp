// P8: whichever choices and passes make the programs of a robot, their results are the same.
//
// All are held against the reference with the tolerances of the checks, which are a few hundred roundings.
#include <gtest/gtest.h>

#include "interpreted_robot.h"
#include "random_robot.h"
#include "symbolic/text.h"
#include "volume.h"

namespace robcogen::numeric {
namespace {

using model::KinematicTree;

// None, all, each one alone, all but one.
std::vector<std::vector<std::string>> choices() {
  std::vector<std::vector<std::string>> result{{}, all_steps()};
  for (const std::string& name : all_steps()) {
    result.push_back({name});
    std::vector<std::string> others = all_steps();
    std::erase(others, name);
    result.push_back(others);
  }
  return result;
}

std::string text_of(const std::vector<std::string>& passes) {
  std::string text = "steps:";
  for (const std::string& name : passes) text += " " + name;
  return text + "\n";
}

TEST(Passes, ChangeNoResult) {
  for (int i = 0; i < volume("ROBCOGEN_TEST_ROBOTS", 60); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 40000;
    const KinematicTree robot = random_robot(seed, {.max_joints = 10});
    for (const std::vector<std::string>& passes : choices()) {
      const auto report = [&](const KinematicTree& r) {
        return check_all(InterpretedRobot(r, random_desired(seed, r), passes), seed, 1).failure_report();
      };
      const std::string found = report(robot);
      if (found.empty()) continue;
      const KinematicTree small = shrink(robot, [&](const KinematicTree& r) { return !report(r).empty(); });
      FAIL() << "seed " << seed << ", " << text_of(passes) << found << "shrunk to\n" << describe(small);
    }
  }
}

// Passes have a point: together they leave fewer operations, and no pass adds any.
TEST(Passes, AddNoOperation) {
  long before = 0, after = 0;
  for (std::uint64_t seed = 40000; seed < 40040; ++seed) {
    const KinematicTree robot = random_robot(seed, {.max_joints = 10});
    const InterpretedRobot raw(robot, {}, algorithm::choices()), passed(robot, {});
    for (const auto& [name, program] : raw.programs()) {
      const std::size_t left = passed.programs().at(name).statements.size();
      EXPECT_LE(left, program.statements.size()) << "seed " << seed << " " << name;
      before += static_cast<long>(program.statements.size());
      after += static_cast<long>(left);
    }
  }
  EXPECT_LT(after, before);
}

}  // namespace
}  // namespace robcogen::numeric
