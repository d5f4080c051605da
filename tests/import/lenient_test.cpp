// URDFs that say less than the format asks for, or say it in another way.
#include "reading.h"

namespace robcogen::lenient_test {
namespace {

// A base and an arm that turns about z. `head` is the opening tag of the robot; `more` is added to its end.
std::string turning_arm(
    const std::string& head,
    const std::string& inertial_of_base = "",
    const std::string& more = "") {
  return head + R"(<link name="base">)" + inertial_of_base +
         R"(</link><link name="arm"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
            </inertial></link><joint name="hinge" type="revolute"><parent link="base"/><child link="arm"/>
            <axis xyz="0 0 1"/><limit effort="1" velocity="1"/></joint>)" +
         more + "</robot>";
}

constexpr const char* kHead = R"(<robot name="robot">)";

TEST(LenientUrdf, SignOfAGearRatioDoesNotMatter) {
  const std::string transmission =
      R"(<transmission name="t"><joint name="hinge"/><actuator name="m"><drake:rotor_inertia value=" 0.125 "/>
         <drake:gear_ratio value="-8"/></actuator></transmission>)";
  const model::KinematicTree tree = test::tree_of(turning_arm(kHead, "", transmission));
  EXPECT_EQ(model::evaluate(tree.joints[0].drive.armature), 8.0);
}

TEST(LenientUrdf, RobotWithoutANameHasThatOfItsFile) {
  const auto name_in = [](const char* source) {
    Diagnostics diagnostics;
    const auto tree = import::urdf(std::make_shared<Source>(source, turning_arm("<robot>")), {}, diagnostics);
    EXPECT_TRUE(tree) << diagnostics.render();
    return tree ? tree->name : "";
  };
  EXPECT_EQ(name_in("models/my-arm.v2.urdf"), "my_arm");
  EXPECT_EQ(name_in("<standard input>"), "robot");
}

TEST(LenientUrdf, InertialWithoutMassOfAFixedBaseIsLeftOut) {
  const std::string inertial = R"(<inertial><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>)";
  EXPECT_FALSE(test::tree_of(turning_arm(kHead, inertial)).links[0].inertia.has_value());
  EXPECT_FALSE(test::imported(turning_arm(kHead, inertial), {.floating_base = true}).tree);
}

}  // namespace
}  // namespace robcogen::lenient_test
