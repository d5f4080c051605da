// How the text of a library grows with the number of joints of a chain.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "run_tool.h"

namespace robcogen::test::growth_test {
namespace {

namespace fs = std::filesystem;

// Links in a row; each axis is perpendicular to the one before.
std::string chain(int joints) {
  std::string text = "Robot Chain {\nRobotBase base { children { l1 via j1 } }\n", placements;
  for (int k = 1; k <= joints; ++k) {
    const std::string number = std::to_string(k), next = std::to_string(k + 1);
    text +=
        "link l" + number + " { id = " + number +
        " inertia_params { mass = 1.0 CoM = (0.01, 0.02, 0.1) Ix = 0.02 Iy = 0.03 Iz = 0.02 Ixy = 0.001 Ixz = 0.002 "
        "Iyz = 0.001 } children {" +
        (k < joints ? " l" + next + " via j" + next : "") + " } }\n";
    placements += "r_joint j" + number + " { ref_frame { translation = (0.0, 0.0, 0.2) rotation = (" +
                  (k % 2 ? "PI/2.0" : "-PI/2.0") + ", 0.0, 0.0) } }\n";
  }
  return text + placements + "}\n";
}

// Generates its library with these options.
Outcome generate(int joints, const Scratch& scratch, const std::string& options) {
  write_text(scratch.path / "chain.kindsl", chain(joints));
  Outcome run = run_tool(
      "generate " + quoted(scratch.path / "chain.kindsl") + " -o " + quoted(scratch.path / "out") + " --effort 0 " +
      options);
  EXPECT_EQ(run.status, 0) << run.errors;
  return run;
}

long lines_of_frames(int joints) {
  const Scratch scratch("chain-" + std::to_string(joints));
  generate(joints, scratch, "--algorithms energy transforms jacobians world");
  long count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(scratch.path / "out")) {
    if (!entry.is_regular_file()) continue;
    const std::string text = read_text(entry.path());
    count += std::count(text.begin(), text.end(), '\n');
  }
  return count;
}

// With functions of all links, it would grow with the square.
TEST(Growth, OfFunctionsOfFramesIsLinear) {
  long before = 0;
  for (const int joints : {10, 20, 40, 80}) {
    const long now = lines_of_frames(joints);
    if (before > 0) {
      EXPECT_LE(static_cast<double>(now), 1.15 * 2 * static_cast<double>(before)) << joints;
    }
    before = now;
  }
}

// Written out, it would grow with the cube.
TEST(Growth, TheInverseOfALargeInertiaMatrixIsALoop) {
  for (const int joints : {10, 30}) {
    const Scratch scratch("inverse-" + std::to_string(joints));
    generate(joints, scratch, "--algorithms joint_space_inertia_factor --batch --processors baseline");
    const std::string text = read_text(scratch.path / "out" / "chain" / "kernel" / "joint_space_inertia_factor.h");
    EXPECT_FALSE(text.empty());
    EXPECT_EQ(text.find("ColumnSolver") != std::string::npos, joints == 30);
    EXPECT_EQ(text.find("mirror_lower<30>(inverse)") != std::string::npos, joints == 30);
    // Over many states, the loop is called, too; smaller inverses are written in place.
    const std::string batch = read_text(scratch.path / "out" / "chain" / "batch" / "joint_space_inertia_factor.h");
    EXPECT_EQ(batch.find("chain::kernel::inertia_factor_inverse(") != std::string::npos, joints == 30);
    EXPECT_EQ(batch.find("chain::batch::columns::inertia_factor_inverse(") != std::string::npos, joints == 10);
  }
}

}  // namespace
}  // namespace robcogen::test::growth_test
