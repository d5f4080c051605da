// P8: the results of a robot's programs do not depend on the choices and passes that make them.
//
// All programs are compared with the reference, with the tolerances of the checks, which are a few hundred roundings.
#include <gtest/gtest.h>

#include <random>

#include "interpreted_robot.h"
#include "random_robot.h"
#include "symbolic/text.h"
#include "volume.h"

namespace robcogen::numeric::passes_test {
namespace {

using model::KinematicTree;

// No step, all steps, each one alone, and all but one.
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
  for (int i = 0; i < volume("ROBCOGEN_TEST_ROBOTS", 12); ++i) {
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

// Link frames that depend only on the robot and the seed, so that shrinking the robot shrinks them, too.
algorithm::LinkFrames random_frames(const KinematicTree& robot, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  algorithm::LinkFrames frames;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    algorithm::LinkFrame frame;
    if (uniform(0, 1) < 0.4)
      frame.turn = model::Quantity(uniform(-3, 3));
    else if (uniform(0, 1) < 0.5)
      frame.turn = model::Quantity(Number::pi_multiple(static_cast<int>(uniform(-2, 3)), 2));
    if (uniform(0, 1) < 0.6) frame.slide = model::Quantity(uniform(-0.5, 0.5));
    frame.turns_with_joint = uniform(0, 1) < 0.5;
    frames.push_back(frame);
  }
  return frames;
}

// Forces on the joints and the base do not depend on the link frames of the recursions, with base inertial parameters
// and without.
TEST(LinkFrames, ChangeNoResult) {
  std::vector<std::string> physical = all_steps();
  std::erase(physical, "base-parameters");
  for (int i = 0; i < volume("ROBCOGEN_TEST_ROBOTS", 10); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 50000;
    const KinematicTree robot = random_robot(seed, {.max_joints = 10});
    const std::vector<std::string>& steps = i % 3 == 0 ? physical : all_steps();
    const auto report = [&](const KinematicTree& r) {
      return check_all(InterpretedRobot(r, random_desired(seed, r), steps, {}, random_frames(r, seed)), seed, 1)
          .failure_report();
    };
    const std::string found = report(robot);
    if (found.empty()) continue;
    const KinematicTree small = shrink(robot, [&](const KinematicTree& r) { return !report(r).empty(); });
    FAIL() << "seed " << seed << ", " << found << "shrunk to\n" << describe(small);
  }
}

// The frames that the search finds change no result.
TEST(LinkFrames, ThatAreFoundChangeNoResult) {
  for (int i = 0; i < volume("ROBCOGEN_TEST_ROBOTS", 10); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 51000;
    const KinematicTree robot = random_robot(seed, {.max_joints = 8});
    algorithm::Formulation formulation;
    formulation.effort = 1;
    algorithm::FormulationChoices formulations(robot, formulation);
    for (const algorithm::LinkFrames& frames :
         {formulations.newton_euler().frames, formulations.inertia().frames,
          formulations.forward_dynamics().formulation.frames}) {
      const std::string found =
          check_all(InterpretedRobot(robot, {}, all_steps(), {}, frames), seed, 1).failure_report();
      EXPECT_EQ(found, "") << "seed " << seed << " " << describe(robot);
    }
  }
}

// Together the passes leave fewer operations, and they add none to any program.
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
}  // namespace robcogen::numeric::passes_test
