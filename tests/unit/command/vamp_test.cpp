// The option --vamp: a header for the planner VAMP. tests/shapes compiles one.
#include <gtest/gtest.h>

#include <utility>

#include "run_tool.h"

namespace robcogen::test::vamp_test {
namespace {

namespace fs = std::filesystem;

Outcome generate(const fs::path& model, const Scratch& scratch, const std::string& options) {
  return run_tool("generate " + quoted(model) + " -o " + quoted(scratch.path / "out") + " --effort 0 " + options);
}

TEST(Vamp, RobotsThatItCannotPlanForAreRefused) {
  const Scratch scratch("vamp-refused");
  const fs::path model = scratch.path / "pair.xml";
  const std::string geom = "<geom type='sphere' size='0.1'/>";
  write_text(
      model, "<mujoco><worldbody><body name='base'><freejoint/>" + geom +
                 "<body name='slow' pos='0 0 1'><joint name='A' type='ball'/>" + geom +
                 "<body name='fast' pos='0 0 1'><joint name='B' type='slide'/>" + geom +
                 "</body></body></body></worldbody></mujoco>\n");
  const Outcome run = generate(model, scratch, "--vamp foot");
  if (run.errors.find("[mjcf-unavailable]") != std::string::npos) GTEST_SKIP() << run.errors;
  EXPECT_EQ(run.status, 1);
  for (const char* message :
       {"--vamp: the base of robot '", "--vamp: joint 'A' is spherical", "--vamp: joint 'B' has no limits",
        "has no frame 'foot'"})
    EXPECT_NE(run.errors.find(message), std::string::npos) << message << "\n" << run.errors;
  EXPECT_FALSE(fs::exists(scratch.path / "out"));
}

TEST(Vamp, IsForRobots) {
  const Scratch scratch("vamp-transforms");
  const Outcome run = generate(fs::path(ROBCOGEN_ROBOTS_DIR) / "euler" / "euler.motdsl", scratch, "--vamp tool");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.errors.find("--vamp applies to robots only"), std::string::npos) << run.errors;
}

}  // namespace
}  // namespace robcogen::test::vamp_test
