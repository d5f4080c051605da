// All functions of random robots in the interpreter, compared with the reference and with the identities P1 to P5.
//
// ROBCOGEN_TEST_ROBOTS and ROBCOGEN_TEST_STATES raise the volume.
#include <gtest/gtest.h>

#include <cstdlib>

#include "interpreted_robot.h"
#include "random_robot.h"
#include "volume.h"

namespace robcogen::numeric::random_robots_test {
namespace {

using model::KinematicTree;

// Passes take most of the time, so the programs of seven robots in eight run as they were traced.
reference::Checks checks_of(const KinematicTree& robot, std::uint64_t seed) {
  const std::vector<std::string> passes = seed % 8 == 0 ? pass::names() : std::vector<std::string>{};
  return check_all(InterpretedRobot(robot, random_desired(seed, robot), passes), seed, state_count());
}

// Shards let a test runner distribute the robots.
constexpr int kShards = 20;

class RandomRobots : public testing::TestWithParam<int> {};

TEST_P(RandomRobots, AgreeWithTheReferenceAndWithThemselves) {
  for (int i = GetParam(); i < robot_count(); i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const KinematicTree robot = random_robot(seed);
    const reference::Checks checks = checks_of(robot, seed);
    if (checks.failures() == 0) continue;
    if (std::getenv("ROBCOGEN_MUTANT") != nullptr) FAIL();  // a mutant needs no small robot
    const KinematicTree small =
        shrink(robot, [&](const KinematicTree& r) { return checks_of(r, seed).failures() > 0; });
    ADD_FAILURE() << "seed " << seed << "\n"
                  << checks.failure_report() << "shrunk to\n"
                  << describe(small) << checks_of(small, seed).failure_report();
    return;
  }
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomRobots, testing::Range(0, kShards));

}  // namespace
}  // namespace robcogen::numeric::random_robots_test
