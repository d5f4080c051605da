// SDF models give the same robots as URDFs that were written by hand, whose reader shares neither frames nor topology
// with that of SDF, and numbers that were computed by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "export/kinematics.h"
#include "import/sdf.h"
#include "import/urdf.h"
#include "language/kinematics/document.h"
#include "model/compound.h"

namespace robcogen::sdf_content_test {
namespace {

namespace fs = std::filesystem;

model::KinematicTree tree_of(
    const std::string& text,
    const import::SdfOptions& options = {},
    const fs::path& file = "robot.sdf") {
  Diagnostics diagnostics;
  const auto robot = import::sdf(std::make_shared<Source>("robot.sdf", text), file, options, diagnostics);
  EXPECT_TRUE(robot) << diagnostics.render() << text;
  return robot ? robot->tree : model::KinematicTree();
}

std::string robot_document(const model::KinematicTree& tree) {
  return language::kinematics::print(exporting::kinematics_document(tree));
}

std::string sdf(const std::string& content, const std::string& version = "1.9", const std::string& attributes = "") {
  return "<sdf version='" + version + "'><model name='m' " + attributes + ">" + content + "</model></sdf>";
}

std::string document_of(const std::string& content, const std::string& version = "1.9") {
  return robot_document(tree_of(sdf(content, version)));
}

std::string document_of_urdf(const std::string& content, const import::UrdfOptions& options = {}) {
  Diagnostics diagnostics;
  const auto tree = import::urdf(
      std::make_shared<Source>("robot.urdf", "<robot name='m'>" + content + "</robot>"), options, diagnostics);
  EXPECT_TRUE(tree) << diagnostics.render();
  return tree ? robot_document(*tree) : "";
}

std::string inertial(const std::string& pose = "0 0 0.1 0 0 0") {
  return "<inertial><pose>" + pose +
         "</pose><mass>2</mass><inertia><ixx>0.03</ixx><iyy>0.04</iyy><izz>0.05</izz><ixy>0.001</ixy>"
         "<ixz>0.002</ixz><iyz>-0.003</iyz></inertia></inertial>";
}

std::string link(const std::string& name, const std::string& pose = "", const std::string& more = inertial()) {
  return "<link name='" + name + "'>" + pose + more + "</link>";
}

std::string joint(
    const std::string& name,
    const std::string& type,
    const std::string& parent,
    const std::string& child,
    const std::string& more = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent>" + parent + "</parent><child>" + child + "</child>" +
         more + "</joint>";
}

const std::string kToWorld = joint("fix", "fixed", "world", "base");
const std::string kLimit = "<limit><lower>-1</lower><upper>2</upper><effort>30</effort><velocity>4</velocity></limit>";

// The arm of the following tests as a URDF.
std::string arm_in_urdf(const std::string& passive = "") {
  const std::string inertial =
      "<inertial><origin xyz='0 0 0.1'/><mass value='2'/><inertia ixx='0.03' iyy='0.04' izz='0.05' ixy='0.001' "
      "ixz='0.002' iyz='-0.003'/></inertial>";
  return "<link name='world'/><link name='base'>" + inertial + "</link><link name='upper'>" + inertial +
         "</link><link name='lower'>" + inertial + "</link><link name='tool'>" + inertial +
         "</link><joint name='fix' type='fixed'><parent link='world'/><child link='base'/></joint>"
         "<joint name='shoulder' type='revolute'><origin xyz='0 0 0.3' rpy='0 0 0.2'/><parent link='base'/>"
         "<child link='upper'/><axis xyz='0 1 0'/><limit lower='-1' upper='2' effort='30' velocity='4'/>" +
         passive +
         "</joint><joint name='slide' type='prismatic'><origin xyz='0.5 0 0' rpy='0.1 0 0'/><parent link='upper'/>"
         "<child link='lower'/><axis xyz='1 0 0'/><limit lower='-1' upper='2' effort='30' velocity='4'/></joint>"
         "<joint name='mount' type='fixed'><origin xyz='0 0.2 0' rpy='0 0.3 0'/><parent link='lower'/>"
         "<child link='tool'/></joint>";
}

// The links and joints of a robot document. What is fixed to the world has no mass here, unlike in a URDF.
std::string moving(const std::string& document) {
  return document.substr(std::min(document.find("\n    link "), document.size()));
}

// Frames of joints and links where a URDF has them, as a conversion of a URDF writes them.
std::string arm_by_joints(const std::string& passive = "") {
  return link("base") + link("upper", "<pose relative_to='shoulder'/>") + link("lower", "<pose relative_to='slide'/>") +
         link("tool", "<pose relative_to='mount'/>") + kToWorld +
         joint(
             "shoulder", "revolute", "base", "upper",
             "<pose relative_to='base'>0 0 0.3 0 0 0.2</pose><axis><xyz>0 1 0</xyz>" + kLimit + passive + "</axis>") +
         joint(
             "slide", "prismatic", "upper", "lower",
             "<pose relative_to='upper'>0.5 0 0 0.1 0 0</pose><axis><xyz>1 0 0</xyz>" + kLimit + "</axis>") +
         joint("mount", "fixed", "lower", "tool", "<pose relative_to='lower'>0 0.2 0 0 0.3 0</pose>");
}

TEST(Sdf, IsTheUrdfThatItWasConvertedFrom) {
  const std::string document = moving(document_of(arm_by_joints()));
  EXPECT_FALSE(document.empty());
  EXPECT_EQ(document, moving(document_of_urdf(arm_in_urdf())));
}

TEST(Sdf, HasDampingFrictionAndSprings) {
  import::UrdfOptions options;
  options.passive_forces = true;
  EXPECT_EQ(
      moving(document_of(arm_by_joints("<dynamics><damping>0.5</damping><friction>0.25</friction></dynamics>"))),
      moving(document_of_urdf(arm_in_urdf("<dynamics damping='0.5' friction='0.25'/>"), options)));
  const model::KinematicTree tree = tree_of(sdf(arm_by_joints(
      "<dynamics><spring_stiffness>7</spring_stiffness><spring_reference>0.5</spring_reference></dynamics>")));
  EXPECT_EQ(model::evaluate(tree.joints[0].drive.stiffness), 7);
  EXPECT_EQ(model::evaluate(tree.joints[0].drive.rest), 0.5);
}

// The other ways to place the links of one robot, with angles that the reader keeps exact.
TEST(Sdf, PosesMayBeRelativeToAnyFrame) {
  const auto arm = [](const std::string& upper, const std::string& shoulder, const std::string& more = "") {
    return document_of(
        link("base") + more + link("upper", upper) + kToWorld +
        joint("shoulder", "revolute", "base", "upper", shoulder + "<axis><xyz>0 0 1</xyz></axis>"));
  };
  const std::string expected = arm("<pose>0.5 0 0.25 0 0 0</pose>", "");
  EXPECT_NE(expected.find("translation = (0.5, 0.0, 0.25)"), std::string::npos) << expected;
  EXPECT_EQ(arm("<pose relative_to='base'>0.5 0 0.25 0 0 0</pose>", ""), expected);
  EXPECT_EQ(arm("<pose relative_to='__model__'>0.5 0 0.25 0 0 0</pose>", ""), expected);
  EXPECT_EQ(arm("<pose relative_to='shoulder'/>", "<pose relative_to='base'>0.5 0 0.25 0 0 0</pose>"), expected);
  // By two quarter turns, of which one is in degrees and one is a quaternion.
  const std::string turns =
      "<frame name='a'><pose degrees='true'>0.5 0 0 0 0 90</pose></frame>"
      "<frame name='b' attached_to='a'><pose rotation_format='quat_xyzw'>0 0 0.25 0 0 -1 1</pose></frame>";
  const std::string by_frames = arm("<pose relative_to='b'/>", "", turns);
  EXPECT_NE(by_frames.find("translation = (0.5, 0.0, 0.25)"), std::string::npos) << by_frames;
}

// The origin of the joint is not that of the link: the reader moves the frame of the model to it.
TEST(Sdf, JointsTurnAboutTheirOwnOrigin) {
  const model::KinematicTree tree = tree_of(
      sdf(link("base") + link("upper", "<pose>0.5 0 0.25 0 0 0</pose>", inertial("0.1 0 0 0 0 0")) + kToWorld +
          joint("j", "continuous", "base", "upper", "<pose>-0.125 0 0 0 0 0</pose><axis><xyz>0 0 1</xyz></axis>")));
  EXPECT_EQ(model::evaluate(tree.joints[0].placement.translation[0]), 0.375);
  EXPECT_EQ(model::evaluate(tree.joints[0].placement.translation[2]), 0.25);
  const model::RigidBodyInertia body = model::in_link_frame(*tree.links[1].inertia);
  EXPECT_DOUBLE_EQ(model::evaluate(body.first_moment[0]), 2 * 0.225);
  EXPECT_DOUBLE_EQ(model::evaluate(body.izz), 0.05 + 2 * 0.225 * 0.225);
  EXPECT_DOUBLE_EQ(model::evaluate(body.ixy), -0.001);
}

// x of the link is y of the model.
TEST(Sdf, AxesAreExpressedInTheFrameThatTheVersionMeans) {
  const auto axis_of = [](const std::string& version, const std::string& axis) {
    const model::KinematicTree tree = tree_of(
        sdf(link("base") + link("upper", "<pose>0 0 0 0 0 1.5</pose>") + kToWorld +
                joint("j", "revolute", "base", "upper", "<axis>" + axis + "</axis>"),
            version));
    const auto R = model::rotation_matrix(tree.joints[0].placement);
    return std::array<double, 2>{model::evaluate(R[0][2]), model::evaluate(R[1][2])};
  };
  const auto expect = [](const std::array<double, 2>& axis, double x, double y) {
    EXPECT_NEAR(axis[0], x, 1e-15);
    EXPECT_NEAR(axis[1], y, 1e-15);
  };
  const std::string x = "<xyz>1 0 0</xyz>", of_model = "<use_parent_model_frame>1</use_parent_model_frame>";
  for (const char* version : {"1.5", "1.6", "1.7", "1.11"}) expect(axis_of(version, x), std::cos(1.5), std::sin(1.5));
  expect(axis_of("1.4", x), 1, 0);
  expect(axis_of("1.6", x + of_model), 1, 0);
  expect(axis_of("1.7", "<xyz expressed_in='__model__'>1 0 0</xyz>"), 1, 0);
  expect(axis_of("1.7", "<xyz expressed_in='base'>0 1 0</xyz>"), 0, 1);
}

TEST(Sdf, BaseFloatsUnlessAJointLeadsToTheWorld) {
  const std::string arm =
      link("base", "<pose>0 0 1 0 0 0</pose>") + link("upper") + joint("j", "revolute", "base", "upper");
  const model::KinematicTree floating = tree_of(sdf(arm));
  EXPECT_TRUE(floating.floating_base);
  EXPECT_EQ(floating.links[0].name, "base");
  const model::KinematicTree fixed = tree_of(sdf(arm + kToWorld));
  EXPECT_FALSE(fixed.floating_base);
  EXPECT_EQ(fixed.links[0].name, "world");
  EXPECT_EQ(fixed.user_frames[0].name, "base");
  EXPECT_EQ(model::evaluate(fixed.user_frames[0].placement.translation[2]), 1);
  const model::KinematicTree block = tree_of(sdf("<static>true</static>" + link("base")));
  EXPECT_FALSE(block.floating_base);
  EXPECT_EQ(block.joints.size(), 0u);
}

TEST(Sdf, HasBallUniversalAndScrewJoints) {
  const model::KinematicTree tree = tree_of(
      sdf(link("base") + link("a") + link("b") + link("c") + link("d") + kToWorld + joint("ball", "ball", "base", "a") +
          joint(
              "cross", "universal", "a", "b",
              "<pose>0 0 0 0 0 0.5</pose><axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>") +
          joint("screw", "screw", "b", "c", "<screw_thread_pitch>0.5</screw_thread_pitch>") +
          joint("old", "screw", "c", "d", "<thread_pitch>-20</thread_pitch>")));
  ASSERT_EQ(tree.dof(), 7);
  EXPECT_EQ(tree.joints[0].type, model::JointType::spherical);
  EXPECT_EQ(tree.joints[3].name, "cross_axis");
  EXPECT_EQ(tree.joints[4].name, "cross_axis2");
  // The first axis is that of the frame of the joint, and the second one is a quarter turn from it.
  const auto first = model::rotation_matrix(tree.joints[3].placement),
             second = model::rotation_matrix(tree.joints[4].placement);
  EXPECT_DOUBLE_EQ(model::evaluate(first[0][2]), std::cos(0.5));
  EXPECT_DOUBLE_EQ(model::evaluate(first[1][2]), std::sin(0.5));
  EXPECT_EQ(model::evaluate(second[2][2]), 0);
  EXPECT_EQ(tree.joints[5].type, model::JointType::helical);
  EXPECT_NEAR(model::evaluate(tree.joints[5].pitch), 0.5 / (2 * 3.14159265358979323846), 1e-16);
  EXPECT_DOUBLE_EQ(model::evaluate(tree.joints[6].pitch), 0.05);
}

TEST(Sdf, JointsMimicOthers) {
  const std::string fingers =
      link("base") + link("left") + link("right") + kToWorld + joint("leader", "revolute", "base", "left") +
      joint(
          "follower", "revolute", "base", "right",
          "<axis><mimic joint='leader'><multiplier>-2</multiplier><offset>0.5</offset><reference>0.125</reference>"
          "</mimic></axis>");
  const model::KinematicTree tree = tree_of(sdf(fingers, "1.11"));
  ASSERT_EQ(tree.couplings.size(), 1u);
  EXPECT_EQ(model::evaluate(tree.couplings[0].terms[0].factor), -2);
  EXPECT_EQ(model::evaluate(tree.couplings[0].offset), 0.75);
  EXPECT_EQ(tree_of(sdf(fingers, "1.11"), {.free_mimic_joints = true}).dof(), 2);
}

// A joint whose child has a parent already.
TEST(Sdf, JointsCloseLoops) {
  const std::string four_bar =
      link("ground") + link("crank", "<pose>0 0 0 0 0 0</pose>") + link("rocker", "<pose>0 1 0 0 0 0</pose>") +
      link("coupler", "<pose>0 0 0.5 0 0 0</pose>") + joint("fix", "fixed", "world", "ground") +
      joint("a", "revolute", "ground", "crank", "<axis><xyz>1 0 0</xyz></axis>") +
      joint("b", "revolute", "ground", "rocker", "<axis><xyz>1 0 0</xyz></axis>") +
      joint("c", "revolute", "crank", "coupler", "<axis><xyz>1 0 0</xyz></axis>") +
      joint("d", "revolute", "rocker", "coupler", "<pose>0 1 0 0 0 0</pose><axis><xyz>1 0 0</xyz></axis>");
  const model::KinematicTree tree = tree_of(sdf(four_bar));
  ASSERT_EQ(tree.loops.size(), 1u);
  EXPECT_EQ(tree.loops[0].type, model::LoopType::hinge);
  EXPECT_EQ(tree.dof(), 1);
}

const std::string kHand = link("palm") + link("finger", "<pose>0 0 0.25 0 0 0</pose>") +
                          joint("curl", "revolute", "palm", "finger", "<axis><xyz>0 1 0</xyz></axis>");

// The same robot by a nested model, by an included one, and by one that is merged.
TEST(Sdf, ModelsMayBeNestedAndIncluded) {
  const fs::path folder = fs::path(testing::TempDir()) / "robcogen_sdf";
  fs::remove_all(folder);
  fs::create_directories(folder / "hand");
  std::ofstream(folder / "hand" / "model.config")
      << "<model><sdf version='1.5'>old.sdf</sdf><sdf version='1.9'>hand.sdf</sdf></model>";
  std::ofstream(folder / "hand" / "hand.sdf") << "<sdf version='1.9'><model name='hand'>" << kHand << "</model></sdf>";
  const auto arm = [&](const std::string& hand, const std::string& palm) {
    return robot_document(tree_of(
        sdf(link("base") + hand + kToWorld + joint("wrist", "revolute", "base", palm)), {}, folder / "arm.sdf"));
  };
  const std::string pose = "<pose>0.5 0 0 0 0 0</pose>";
  const std::string nested = arm("<model name='hand'>" + pose + kHand + "</model>", "hand::palm");
  EXPECT_NE(nested.find("hand__finger"), std::string::npos) << nested;
  EXPECT_EQ(arm("<include><uri>model://hand</uri>" + pose + "</include>", "hand::palm"), nested);
  EXPECT_EQ(arm("<include><uri>hand/hand.sdf</uri><name>hand</name>" + pose + "</include>", "hand"), nested);
  EXPECT_EQ(
      arm("<include><uri>package://hand/hand.sdf</uri><placement_frame>finger</placement_frame>"
          "<pose>0.5 0 0.25 0 0 0</pose></include>",
          "hand::palm"),
      nested);
  std::string merged = arm("<include merge='true'><uri>hand</uri>" + pose + "</include>", "palm");
  EXPECT_NE(merged.find("link finger"), std::string::npos) << merged;
  EXPECT_EQ(merged.find("hand__"), std::string::npos) << merged;
  fs::remove_all(folder);
}

TEST(Sdf, WorldsHaveTheirRobotAmongStaticModels) {
  const std::string robot = "<model name='m'>" + link("base") + link("upper") + joint("j", "revolute", "base", "upper");
  const std::string ground = "<model name='ground'><static>true</static><link name='plane'/></model>";
  const std::string to_world = joint("fix", "fixed", "world", "m::base");
  const auto world = [](const std::string& content) {
    return robot_document(tree_of("<sdf version='1.9'><world name='w'>" + content + "</world></sdf>"));
  };
  const std::string expected = robot_document(tree_of(
      sdf(link("base") + link("upper") + joint("j", "revolute", "base", "upper") +
          joint("fix", "fixed", "world", "base"))));
  EXPECT_EQ(world(ground + robot + "</model>" + to_world), expected);
  EXPECT_EQ(world(robot + joint("fix", "fixed", "world", "base") + "</model>" + ground), expected);
}

TEST(Sdf, AnglesAreSnapped) {
  const std::string arm = link("base") + link("upper", "<pose>0 0 0 1.570796 0 0</pose>") + kToWorld +
                          joint("j", "revolute", "base", "upper");
  const model::KinematicTree tree = tree_of(sdf(arm), {.snap_angles = true});
  EXPECT_EQ(model::evaluate(model::rotation_matrix(tree.joints[0].placement)[2][2]), 0);
}

}  // namespace
}  // namespace robcogen::sdf_content_test
