// The compiled code of one robot, judged on its exported URDF. Compiled once per robot, with the definitions of
// robcogen/reference's self-check, and
//     ROBOT   the robot's target
//     URDF    path
#include <gtest/gtest.h>

#include ROBCOGEN_ROBOT_HEADER
#include ROBCOGEN_REFLECTION_HEADER

#include "judge.h"
#include "robcogen/reference/compiled_robot.h"

namespace generated = ROBCOGEN_ROBOT_NAMESPACE;

namespace robcogen::oracles {
namespace {

const Decisions kDecisions = {
    {
        // KDL supports only fixed bases.
        {"KDL", "quadruped", "no floating base"},
        {"KDL", "centaur", "no floating base"},
        {"KDL", "humanoid", "no floating base"},
        {"KDL chain", "quadruped", "no floating base"},
        {"KDL chain", "centaur", "no floating base"},
        {"KDL chain", "humanoid", "no floating base"},
        // These robots branch.
        {"KDL chain", "tree5", "one chain"},
        {"KDL chain", "quadruped_fixed", "one chain"},
    },
    {}};

Judged compiled_robot() {
  const reflection::Robot& tables = generated::reflection::robot;
  return judged(URDF, tables, std::make_shared<const reference::CompiledRobot<generated::Robot>>(tables));
}

}  // namespace
}  // namespace robcogen::oracles

int main(int argc, char** argv) {
  using namespace robcogen::oracles;
  testing::InitGoogleTest(&argc, argv);
  register_tests(ROBOT, compiled_robot, kDecisions);
  return RUN_ALL_TESTS();
}
