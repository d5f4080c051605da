// Robots in other formats, imported as parts of a robot document.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "run_tool.h"

namespace robcogen::test::parts_test {
namespace {

constexpr const char* kUrdf = R"(<?xml version="1.0"?>
<robot name="finger">
  <link name="mount"/>
  <link name="phalanx">
    <inertial>
      <origin xyz="0.1 0.02 0.03"/>
      <mass value="0.7"/>
      <inertia ixx="0.01" iyy="0.02" izz="0.025" ixy="0.001" ixz="0.002" iyz="0.003"/>
    </inertial>
  </link>
  <joint name="bend" type="revolute">
    <parent link="mount"/>
    <child link="phalanx"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.4 0.5 0.6"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="5" velocity="2"/>
  </joint>
</robot>
)";

constexpr const char* kMjcf = R"(<mujoco model="finger">
  <compiler angle="radian"/>
  <worldbody>
    <body name="phalanx" pos="0.1 0.2 0.3" euler="0.4 0.5 0.6">
      <joint name="bend" axis="0 1 0"/>
      <inertial pos="0.1 0.02 0.03" mass="0.7" fullinertia="0.01 0.02 0.025 0.001 0.002 0.003"/>
    </body>
  </worldbody>
</mujoco>
)";

// A robot that is attached at the origin of the base has the same dynamics as on its own.
class ImportedRobot : public testing::TestWithParam<std::string> {};

TEST_P(ImportedRobot, AtTheOriginMovesAsByItself) {
  const Scratch scratch("imported");
  const std::string& name = GetParam();
  write_text(scratch.path / name, name.ends_with(".urdf") ? kUrdf : kMjcf);
  write_text(
      scratch.path / "hand.kindsl",
      "import \"" + name + "\" as Finger\n\nRobot Hand {\n    RobotBase palm { children { Finger a() } }\n}\n");
  const std::string state = R"({"q": [0.3], "qd": [0.4], "qdd": [0.5]})";
  const std::string call = " inverse_dynamics --quiet";
  const Outcome alone = run_tool("eval " + quoted(scratch.path / name) + call, state);
  const Outcome attached = run_tool("eval " + quoted(scratch.path / "hand.kindsl") + call, state);
  ASSERT_EQ(alone.status, 0) << alone.errors;
  ASSERT_EQ(attached.status, 0) << attached.errors;
  const auto tau = [](const Outcome& run) { return std::stod(run.output.substr(run.output.find('[') + 1)); };
  EXPECT_NEAR(tau(attached), tau(alone), 1e-14);
  EXPECT_GT(std::abs(tau(alone)), 0.01);
  const Outcome expanded = run_tool("print --expand " + quoted(scratch.path / "hand.kindsl"));
  EXPECT_NE(expanded.output.find("link a_phalanx {"), std::string::npos) << expanded.errors << expanded.output;
  EXPECT_NE(expanded.output.find("r_joint a_bend {"), std::string::npos) << expanded.output;
}

INSTANTIATE_TEST_SUITE_P(As, ImportedRobot, testing::Values("finger.urdf", "finger.xml"));

}  // namespace
}  // namespace robcogen::test::parts_test
