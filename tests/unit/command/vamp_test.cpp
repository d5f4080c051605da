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
  const std::string frame = "ref_frame { translation = (0,0,0) rotation = (0,0,0) }",
                    inertia = "inertia_params { mass = 1 CoM = (0,0,0) Ix = 1 Iy = 1 Iz = 1 Ixy = 0 Ixz = 0 Iyz = 0 }";
  const fs::path model = scratch.path / "pair.kindsl";
  write_text(
      model, "Robot Pair {\nRobotBase base floating { " + inertia + " children { slow via A } }\nlink slow { id = 1 " +
                 inertia + " children { fast via B } }\nlink fast { id = 2 " + inertia +
                 " children {} }\ns_joint A { " + frame + " }\np_joint B { " + frame + " }\n}\n");
  const Outcome run = generate(model, scratch, "--vamp foot");
  EXPECT_EQ(run.status, 1);
  for (const char* message :
       {"--vamp: the base of robot 'Pair' floats", "--vamp: joint 'A' is spherical", "--vamp: joint 'B' has no limits",
        "--vamp: robot 'Pair' has no collision shapes", "robot 'Pair' has no frame 'foot'"})
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
