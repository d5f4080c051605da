// Different MJCF spellings of one robot give the same model. (tests/oracles/mjcf_test.cpp compares the numbers with
// MuJoCo.)
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include "export/kinematics.h"
#include "import/mjcf.h"
#include "language/kinematics/document.h"

namespace robcogen::mjcf_content_test {
namespace {

model::KinematicTree tree_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto robot = import::mjcf(std::make_shared<Source>("robot.xml", text), "robot.xml", {}, diagnostics);
  EXPECT_TRUE(robot) << diagnostics.render();
  return robot ? robot->tree : model::KinematicTree();
}

std::string robot_document(const std::string& text) {
  return language::kinematics::print(exporting::kinematics_document(tree_of(text)));
}

const char* const kInertial = "<inertial pos='0 0 0.1' mass='1' diaginertia='1 1 1'/>";

// A body `arm` with these attributes and this content, on a hinge joint.
std::string arm(const std::string& attributes, const std::string& content, const std::string& before = "") {
  return "<mujoco model='m'>" + before + "<worldbody><body name='arm' " + attributes + "><joint name='j'/>" +
         kInertial + content + "</body></worldbody></mujoco>";
}

TEST(Mjcf, OrientationsAreExact) {
  const std::string radians = "<compiler angle='radian'/>";
  const std::string expected = robot_document(arm("euler='90 0 0'", ""));
  EXPECT_NE(expected.find("rotation = (PI/2.0, 0.0, 0.0)"), std::string::npos) << expected;
  for (const char* same :
       {"quat='1 1 0 0'", "quat='-0.707107 -0.707107 0 0'", "axisangle='2 0 0 90'", "axisangle='-1 0 0 -90'",
        "xyaxes='1 0 0 1 0 2'", "zaxis='0 -3 0'"})
    EXPECT_EQ(robot_document(arm(same, "")), expected) << same;
  EXPECT_EQ(robot_document(arm("quat='0 0 1 0'", "", radians)), robot_document(arm("euler='0 180 0'", "")));
}

// MuJoCo 2.2.2 gives these rotations: z points from the second point to the first, by the smallest rotation.
TEST(Mjcf, SitesOfSegmentsTurnAsLittleAsPossible) {
  const auto expect_rotation = [](const std::string& ends, const std::array<std::array<double, 3>, 3>& expected) {
    const std::string site = "<site name='s' type='capsule' size='0.01' fromto='" + ends + "'/>";
    const std::vector<model::UserFrame> frames = tree_of(arm("", site)).user_frames;
    const auto frame = std::find_if(frames.begin(), frames.end(), [](const auto& f) { return f.name == "s"; });
    ASSERT_NE(frame, frames.end());
    const auto R = model::rotation_matrix(frame->placement);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(model::evaluate(R[i][k]), expected[i][k], 1e-15) << ends;
  };
  const double a = 1.0 / 3.0, b = 2.0 / 3.0;
  expect_rotation("0 0 0 0.2 0.1 0.2", {{{-a, -b, -b}, {-b, b, -a}, {b, a, -b}}});
  expect_rotation("0 0 0 0 0 1", {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}});
  expect_rotation("0 0 1 0 0 0", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
}

TEST(Mjcf, FramesMoveWhatTheyHold) {
  const std::string nested =
      "<frame pos='0 0 1' euler='0 0 90'><frame pos='2 0 0'><site name='s' pos='0 1 0'/></frame></frame>";
  EXPECT_EQ(robot_document(arm("", nested)), robot_document(arm("", "<site name='s' pos='-1 2 1' euler='0 0 90'/>")));
}

TEST(Mjcf, FramesMoveJoints) {
  const auto document = [](const std::string& joint) {
    return robot_document("<mujoco><worldbody><body name='b'>" + joint + kInertial + "</body></worldbody></mujoco>");
  };
  const std::string outer = "<frame pos='0 0 1' euler='90 0 0'>", inner = "<frame pos='1 0 0'>";
  for (const std::string type : {"type='hinge' ref='10'", "type='slide' ref='0.1'"})
    EXPECT_EQ(
        document(outer + inner + "<joint name='j' pos='0 0 2' " + type + "/></frame></frame>"),
        document("<joint name='j' pos='1 -2 1' axis='0 -1 0' " + type + "/>"))
        << type;
  EXPECT_EQ(
      document(outer + "<joint name='j' type='ball' pos='0 0 2'/></frame>"),
      document("<joint name='j' type='ball' pos='0 -2 1'/>"));
  EXPECT_EQ(document(outer + "<freejoint/></frame>"), document("<freejoint/>"));
  EXPECT_EQ(document("<frame childclass='main'><joint name='j'/></frame>"), document("<joint name='j'/>"));
}

TEST(Mjcf, FramesChooseTheClassOfTheirContent) {
  const std::string defaults =
      "<default><site pos='1 0 0'/><default class='far'><site pos='9 0 0' euler='0 0 30'/></default></default>";
  EXPECT_EQ(
      robot_document(arm("", "<frame childclass='far'><site name='s'/></frame>", defaults)),
      robot_document(arm("", "<site name='s' pos='9 0 0' euler='0 0 30'/>")));
}

// As in MuJoCo, where a `quat` and an alternative to it are two attributes, and the alternative prevails.
TEST(Mjcf, OrientationsReplaceInheritedOnes) {
  const auto site = [](const std::string& outer, const std::string& inner, const std::string& own) {
    return robot_document(
        arm("", "<site class='c' name='s' " + own + "/>",
            "<default><site " + outer + "/><default class='c'><site " + inner + "/></default></default>"));
  };
  const std::string about_x = "euler='90 0 0'", about_y = "euler='0 90 0'";
  const std::string quaternion = "quat='1 0 0 1'", direction = "zaxis='1 2 3'";
  EXPECT_EQ(site(quaternion, about_x, ""), site("", "", about_x));
  EXPECT_EQ(site(direction, about_x, ""), site("", "", about_x));
  EXPECT_EQ(site(direction, about_x, about_y), site("", "", about_y));
  EXPECT_EQ(site("quat='1 1 0 0'", quaternion, ""), site("", "", quaternion));
  EXPECT_EQ(site(about_x, quaternion, ""), site("", "", about_x));
  EXPECT_EQ(site(about_x, "", quaternion), site("", "", about_x));
  EXPECT_EQ(site(about_x, quaternion, about_y), site("", "", about_y));
}

TEST(Mjcf, ShorterSizesReplaceTheFirstNumbers) {
  const auto geom = [](const std::string& inherited, const std::string& own) {
    const std::string content = "<body><geom type='box' size='" + own + "'/></body>";
    return robot_document(arm("", content, "<default><geom size='" + inherited + "'/></default>"));
  };
  EXPECT_EQ(geom("1 2 3", "4"), geom("", "4 2 3"));
  EXPECT_EQ(geom("1 2 3", "4 5"), geom("1", "4 5 3"));
  EXPECT_EQ(geom("1 2", "4 5 6"), geom("", "4 5 6"));
}

// Two bodies on hinges, of which one follows the other.
std::string coupled(const std::string& before, const std::string& equality) {
  const auto body = [](const std::string& name, const std::string& joint) {
    return "<body name='" + name + "'><joint name='" + joint + "' frictionloss='2'/>" + kInertial + "</body>";
  };
  return "<mujoco>" + before + "<worldbody>" + body("left", "a") + body("right", "b") + "</worldbody><equality>" +
         equality + "</equality></mujoco>";
}

TEST(Mjcf, FlagsDisableConstraints) {
  const auto tree = [](const std::string& flags) {
    return tree_of(coupled("<option><flag " + flags + "/></option>", "<joint joint1='a' joint2='b'/>"));
  };
  const auto friction = [](const model::KinematicTree& robot) {
    return model::evaluate(robot.joints[0].drive.friction);
  };
  EXPECT_EQ(tree("equality='enable' limit='disable'").dof(), 1);
  EXPECT_EQ(friction(tree("equality='disable'")), 2.0);
  EXPECT_EQ(tree("equality='disable'").dof(), 2);
  EXPECT_EQ(tree("frictionloss='disable'").dof(), 1);
  EXPECT_EQ(friction(tree("frictionloss='disable'")), 0.0);
  EXPECT_EQ(tree("constraint='disable'").dof(), 2);
  EXPECT_EQ(friction(tree("constraint='disable' equality='enable'")), 0.0);
}

TEST(Mjcf, EqualitiesHaveDefaults) {
  const std::string defaults =
      "<default><equality active='false'/><default class='on'><equality active='true'/></default></default>";
  EXPECT_EQ(tree_of(coupled(defaults, "<joint joint1='a' joint2='b'/>")).dof(), 2);
  EXPECT_EQ(tree_of(coupled(defaults, "<joint class='on' joint1='a' joint2='b'/>")).dof(), 1);
  EXPECT_EQ(tree_of(coupled(defaults, "<joint active='true' joint1='a' joint2='b'/>")).dof(), 1);
}

TEST(Mjcf, PolynomialsOfEqualitiesMayBeShort) {
  const auto document = [](const std::string& polynomial) {
    return robot_document(coupled("", "<joint joint1='a' joint2='b' " + polynomial + "/>"));
  };
  EXPECT_EQ(document("polycoef='0.5'"), document("polycoef='0.5 1 0 0 0'"));
  EXPECT_EQ(document("polycoef='0.5 -2'"), document("polycoef='0.5 -2 0 0 0'"));
  EXPECT_EQ(document("polycoef='0 1 0'"), document(""));
}

TEST(Mjcf, LimitsFollowRanges) {
  const auto limits = [](const std::string& joint, const std::string& compiler = "") {
    const std::string body = "<body name='b'><joint name='j' " + joint + "/>" + kInertial + "</body>";
    return tree_of("<mujoco>" + compiler + "<worldbody>" + body + "</worldbody></mujoco>").joints[0].limits;
  };
  EXPECT_DOUBLE_EQ(limits("range='-90 180'").upper, 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(limits("range='-90 180'", "<compiler angle='radian'/>").upper, 180.0);
  EXPECT_DOUBLE_EQ(limits("type='slide' range='-90 180'").lower, -90.0);
  EXPECT_EQ(limits("range='-90 180' limited='false'"), model::JointLimits());
  EXPECT_EQ(limits("range='-90 180'", "<compiler autolimits='false'/>"), model::JointLimits());
  EXPECT_DOUBLE_EQ(limits("range='0 1' limited='true'", "<compiler autolimits='false' angle='radian'/>").upper, 1.0);
  EXPECT_DOUBLE_EQ(limits("actuatorfrcrange='-20 30'").effort, 30.0);
}

TEST(Mjcf, BodiesWithoutJointsAreParts) {
  const model::KinematicTree tree =
      tree_of(arm("", "<body name='lid' pos='0 0 1'>" + std::string(kInertial) + "</body>"));
  ASSERT_EQ(tree.links.size(), 2u);
  EXPECT_DOUBLE_EQ(model::evaluate(tree.links[1].inertia->mass), 2.0);
  EXPECT_DOUBLE_EQ(model::evaluate(tree.links[1].inertia->com[2]), 0.6);
}

TEST(Mjcf, GeomsOfSomeGroupsHaveMass) {
  const auto mass = [](const std::string& range) {
    const std::string geoms =
        "<geom size='1' mass='1'/><geom size='1' mass='2' group='2'/><geom type='mesh' group='4'/>";
    const model::KinematicTree tree =
        tree_of(arm("", "<body>" + geoms + "</body>", "<compiler inertiagrouprange='" + range + "'/>"));
    return model::evaluate(tree.links[1].inertia->mass) - 1.0;
  };
  EXPECT_DOUBLE_EQ(mass("0 0"), 1.0);
  EXPECT_DOUBLE_EQ(mass("0 3"), 3.0);
  EXPECT_DOUBLE_EQ(mass("1 2"), 2.0);
  EXPECT_DOUBLE_EQ(mass("3 3"), 0.0);
}

TEST(Mjcf, GeomsOfFixedBodiesNeedNoMass) {
  const model::KinematicTree tree = tree_of(
      arm("", "").insert(sizeof "<mujoco model='m'><worldbody>" - 1, "<body name='table'><geom type='mesh'/></body>"));
  EXPECT_EQ(tree.dof(), 1);
}

// ---- Copies.

TEST(Mjcf, CopiesAreTurnedAndShiftedOneAfterTheOther) {
  const auto leg = [](const std::string& suffix) {
    return "<body name='leg" + suffix + "'><joint name='hip" + suffix + "'/>" + kInertial + "<site name='foot" +
           suffix + "' pos='1 0 0'/></body>";
  };
  EXPECT_EQ(
      robot_document(arm("", "<replicate count='3' offset='2 0 0' euler='0 0 90' sep='_'>" + leg("") + "</replicate>")),
      robot_document(
          arm("", leg("_0") + "<frame pos='2 0 0' euler='0 0 90'>" + leg("_1") +
                      "</frame><frame pos='2 2 0' euler='0 0 180'>" + leg("_2") + "</frame>")));
  // The suffix of the inner copy comes first; ten copies have suffixes of one digit, eleven of two.
  const model::KinematicTree tree =
      tree_of(arm("", "<replicate count='11'><replicate count='2' sep='x'><site name='s'/></replicate></replicate>"));
  const auto has = [&](const std::string& name) {
    return std::any_of(
        tree.user_frames.begin(), tree.user_frames.end(), [&](const auto& frame) { return frame.name == name; });
  };
  EXPECT_TRUE(has("sx000") && has("sx110") && !has("sx0"));
}

TEST(Mjcf, CopiesShareActuatorsAndEqualities) {
  const auto model = [](const std::string& bodies, const std::string& rest) {
    return robot_document("<mujoco><worldbody>" + bodies + "</worldbody>" + rest + "</mujoco>");
  };
  const auto pair = [](const std::string& i) {
    return "<body name='a" + i + "'><joint name='x" + i + "'/>" + kInertial + "<body name='b" + i + "'><joint name='y" +
           i + "'/>" + kInertial + "</body></body>";
  };
  EXPECT_EQ(
      model(
          "<replicate count='2'>" + pair("") + "</replicate>",
          "<equality><joint joint1='y' joint2='x'/></equality><actuator><motor joint='x' armature='2'/></actuator>"),
      model(
          pair("0") + pair("1"),
          "<equality><joint joint1='y0' joint2='x0'/><joint joint1='y1' joint2='x1'/></equality>"
          "<actuator><motor joint='x0' armature='2'/><motor joint='x1' armature='2'/></actuator>"));
}

// ---- Drives.

TEST(Mjcf, ActuatorsAddArmatureAndDamping) {
  const auto model = [](const std::string& joint, const std::string& actuators, const std::string& defaults = "") {
    return robot_document(
        "<mujoco><default>" + defaults + "</default><worldbody><body name='b'><joint name='j' " + joint + "/>" +
        kInertial + "</body></worldbody><actuator>" + actuators + "</actuator></mujoco>");
  };
  EXPECT_EQ(
      model("armature='0.5' damping='1'", "<motor joint='j' gear='3 0 0 0 0 0' armature='0.25' damping='2'/>"),
      model("armature='2.75' damping='19'", ""));
  EXPECT_EQ(
      model("", "<motor joint='j' armature='0.25'/><position jointinparent='j' gear='-2' armature='0.5'/>"),
      model("armature='2.25'", ""));
  // All actuators share their defaults.
  EXPECT_EQ(model("", "<motor joint='j'/>", "<position armature='0.25'/>"), model("armature='0.25'", ""));
}

TEST(Mjcf, SpringDampersFollowFromTheInertia) {
  const auto drive = [](const std::string& joint) {
    const std::string inertial = "<inertial pos='0 0.5 0' mass='2' diaginertia='1 1 1'/>";
    return tree_of("<mujoco><worldbody><body><joint " + joint + "/>" + inertial + "</body></worldbody></mujoco>")
        .joints[0]
        .drive;
  };
  const auto expect = [](const model::Drive& given, double stiffness, double damping) {
    EXPECT_DOUBLE_EQ(model::evaluate(given.stiffness), stiffness);
    EXPECT_DOUBLE_EQ(model::evaluate(given.damping), damping);
  };
  // The moment about the joint is 1 + 2 * 0.5^2 + 0.5.
  expect(drive("armature='0.5' stiffness='9' damping='9' springdamper='0.5 2'"), 2.0 / (0.25 * 4.0), 4.0 / 0.5);
  expect(drive("type='slide' springdamper='0.5 2'"), 2.0 / (0.25 * 4.0), 4.0 / 0.5);
  EXPECT_DOUBLE_EQ(model::evaluate(drive("springdamper='1 1' springref='180'").rest), 3.14159265358979323846);
}

TEST(Mjcf, ActuatorsDampJointsWithSpringDampersToo) {
  const model::KinematicTree tree = tree_of(
      "<mujoco><worldbody><body><joint name='j' springdamper='1 1'/><inertial pos='0 0 0' mass='1' diaginertia='1 1 "
      "1'/>"
      "</body></worldbody><actuator><motor joint='j' damping='3'/></actuator></mujoco>");
  EXPECT_DOUBLE_EQ(model::evaluate(tree.joints[0].drive.damping), 2.0 + 3.0);
}

// ---- Free bodies.

TEST(Mjcf, FreeBodiesAreAligned) {
  const auto body = [](const std::string& pose, const std::string& joint, const std::string& content) {
    return robot_document(
        "<mujoco><worldbody><body name='b' " + pose + "><freejoint " + joint + "/>" + content +
        "</body></worldbody></mujoco>");
  };
  const std::string inertial = "mass='1' diaginertia='1 2 2.5'/>";
  EXPECT_EQ(
      body("", "align='true'", "<inertial pos='1 0 0' euler='0 0 90' " + inertial + "<site name='s'/>"),
      body("", "", "<inertial pos='0 0 0' " + inertial + "<site name='s' pos='0 1 0' euler='0 0 -90'/>"));
  const std::string aligned = "<compiler alignfree='true'/>", box = "<geom type='box' size='1 2 3' pos='0 1 0'/>";
  const auto free = [&](const std::string& joint, const std::string& content) {
    return robot_document(
        "<mujoco>" + aligned + "<worldbody><body name='b'>" + joint + content + "</body></worldbody></mujoco>");
  };
  EXPECT_EQ(free("<freejoint/>", box), free("<freejoint/>", "<geom type='box' size='1 2 3'/>"));
  // Not if the body carries others, or if its joint says otherwise.
  EXPECT_EQ(free("<freejoint align='false'/>", box), body("", "", box));
  EXPECT_EQ(free("<freejoint/>", box + "<body name='c'/>"), body("", "", box + "<body name='c'/>"));
}

// ---- Scenes.

std::string document_of_robot(const std::string& text, const std::string& robot) {
  Diagnostics diagnostics;
  import::MjcfOptions options;
  options.robot = robot;
  const auto read = import::mjcf(std::make_shared<Source>("robot.xml", text), "robot.xml", options, diagnostics);
  EXPECT_TRUE(read) << diagnostics.render();
  return read ? language::kinematics::print(exporting::kinematics_document(read->tree)) : "";
}

TEST(Mjcf, ScenesHaveSeveralRobots) {
  const std::string table = "<body name='table' pos='1 0 0'><site name='corner'/></body>";
  const auto branch = [](const std::string& name, const std::string& joint) {
    return "<body name='" + name + "'>" + joint + kInertial + "</body>";
  };
  const std::string left = branch("left", "<joint name='l'/>"), right = branch("right", "<joint name='r'/>");
  // Masses of other robots need not be known.
  const std::string ball = "<body name='ball'><freejoint/><geom type='mesh' mesh='nothing'/></body>";
  const std::string cube = branch("cube", "<freejoint/>");
  const auto world = [](const std::string& bodies, const std::string& rest = "") {
    return "<mujoco model='m'><worldbody>" + bodies + "</worldbody>" + rest + "</mujoco>";
  };
  const std::string scene = world(
      table + left + ball + right + cube,
      "<equality><joint joint1='r'/></equality><actuator><motor joint='l'/></actuator>");
  EXPECT_EQ(document_of_robot(scene, "left"), robot_document(world(table + left)));
  EXPECT_EQ(
      document_of_robot(scene, "world"),
      robot_document(world(table + left + right, "<equality><joint joint1='r'/></equality>")));
  EXPECT_EQ(document_of_robot(scene, "cube"), robot_document(world(cube)));
  EXPECT_EQ(document_of_robot(world(cube), "cube"), robot_document(world(cube)));
}

// ---- Included files.

// As in MuJoCo, a symbolic link is a file of its own.
TEST(Mjcf, IncludesFilesThroughSymbolicLinks) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "mjcf_links";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const auto write = [&](const char* name, const std::string& text) { std::ofstream(folder / name) << text; };
  write("arm.inc", "<mujoco><body pos='1 0 0'/></mujoco>");
  write("self.inc", "<mujoco><include file='again.inc'/></mujoco>");
  fs::create_symlink("arm.inc", folder / "other.inc");
  fs::create_symlink("self.inc", folder / "again.inc");
  const auto read = [&](const std::string& content) {
    Diagnostics diagnostics;
    const auto source = std::make_shared<Source>((folder / "robot.xml").string(), arm("", content));
    import::mjcf(source, folder / "robot.xml", {}, diagnostics);
    std::vector<std::string> codes;
    for (const Diagnostic& d : diagnostics.all())
      if (d.severity == Severity::error) codes.push_back(d.code);
    return codes;
  };
  using Codes = std::vector<std::string>;
  EXPECT_EQ(read("<include file='arm.inc'/><include file='other.inc'/>"), Codes());
  EXPECT_EQ(read("<include file='arm.inc'/><include file='./arm.inc'/>"), Codes{"included-twice"});
  EXPECT_EQ(read("<include file='self.inc'/>"), Codes{"include-cycle"});
  fs::remove_all(folder);
}

// A crank and a rocker on the world, whose ends an equality connects, and a bar on the crank.
std::string four_bar(const std::string& equality, const std::string& after = "", const std::string& pin = "") {
  return std::string("<mujoco><worldbody><body name='crank'><joint name='turn'/>") + kInertial +
         "<body name='bar' pos='1 0 0'><joint name='pin' " + pin + "/>" + kInertial +
         "<site name='end' pos='0 2 0' euler='0 0 10'/></body></body><body name='rocker' pos='3 1 0'><joint "
         "name='rock'/>" +
         kInertial + "<site name='eye' pos='-2 1 0'/></body></worldbody><equality>" + equality + "</equality>" + after +
         "</mujoco>";
}

std::array<double, 3> position_of(const model::LoopEnd& end) {
  std::array<double, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = model::evaluate(end.placement.translation[i]);
  return result;
}

TEST(Mjcf, LoopsConnectBodiesOrSites) {
  const model::KinematicTree bodies =
      tree_of(four_bar("<connect name='tip' body1='bar' body2='rocker' anchor='0 2 0'/>"));
  const model::KinematicTree sites = tree_of(four_bar("<connect site1='end' site2='eye'/>"));
  ASSERT_EQ(bodies.loops.size(), 1U);
  ASSERT_EQ(sites.loops.size(), 1U);
  EXPECT_EQ(bodies.loops[0].name, "tip");
  EXPECT_EQ(sites.loops[0].name, "bar_rocker");
  EXPECT_EQ(bodies.loops[0].ends[1].frame, "tip_2");
  EXPECT_EQ(sites.loops[0].ends[1].frame, "eye");
  for (const model::KinematicTree& tree : {bodies, sites}) {
    EXPECT_EQ(tree.loops[0].type, model::LoopType::point);
    EXPECT_EQ(position_of(tree.loops[0].ends[0]), (std::array<double, 3>{0, 2, 0}));
    EXPECT_EQ(position_of(tree.loops[0].ends[1]), (std::array<double, 3>{-2, 1, 0}));
    EXPECT_EQ(tree.dof(), 1);
  }
  const std::string held = "<connect body1='bar' anchor='0 2 0'/>";
  EXPECT_EQ(tree_of(four_bar(held)).loops[0].ends[1].link, 0);
  EXPECT_EQ(position_of(tree_of(four_bar(held)).loops[0].ends[1]), (std::array<double, 3>{1, 2, 0}));
  EXPECT_EQ(
      robot_document(four_bar("<connect body1='bar' body2='world' anchor='0 2 0'/>")), robot_document(four_bar(held)));
}

TEST(Mjcf, LoopsCanBeLeftOut) {
  const std::string loop = "body1='bar' body2='rocker' anchor='0 2 0'";
  EXPECT_EQ(robot_document(four_bar("<connect active='false' " + loop + "/>")), robot_document(four_bar("")));
  Diagnostics diagnostics;
  const auto open = import::mjcf(
      std::make_shared<Source>("robot.xml", four_bar("<connect " + loop + "/>")), "robot.xml",
      {.free_equality_joints = true}, diagnostics);
  ASSERT_TRUE(open);
  EXPECT_TRUE(open->tree.loops.empty());
  EXPECT_EQ(open->tree.dof(), 3);
}

TEST(Mjcf, LoopsAreAssembledInTheFirstKeyOrAsDrawn) {
  const std::string loop = "<connect body1='bar' body2='rocker' anchor='0 2 0'/>";
  const auto assembled = [&](const std::string& keys, const std::string& pin = "") {
    std::vector<double> positions;
    for (const model::Joint& joint : tree_of(four_bar(loop, "<keyframe>" + keys + "</keyframe>", pin)).joints)
      positions.push_back(joint.assembled_position());
    return positions;
  };
  using Positions = std::vector<double>;
  EXPECT_EQ(assembled(""), (Positions{0, 0, 0}));
  EXPECT_EQ(assembled("<key time='1'/><key qpos='0.5 -0.4\n0.3'/><key qpos='1 1 1'/>"), (Positions{0.5, -0.4, 0.3}));
  EXPECT_EQ(assembled("", "ref='90'"), (Positions{0, std::acos(-1.0) / 2, 0}));
}

TEST(Mjcf, KeysInWhichLoopsCannotCloseAreIgnored) {
  const auto document = [](const std::string& keys) {
    return robot_document(
        std::string("<mujoco><worldbody><body euler='0 0 10'><joint name='turn' ref='5'/>") + kInertial +
        "<body name='bar' pos='1 0 0'><joint name='pin'/>" + kInertial + "</body></body><body name='slider'>" +
        "<joint type='slide' axis='1 0 0'/>" + kInertial + "</body></worldbody><equality>" +
        "<connect body1='bar' body2='slider' anchor='0.5 0 0'/></equality><keyframe>" + keys + "</keyframe></mujoco>");
  };
  EXPECT_EQ(document("<key qpos='1.4 0 0'/>"), document(""));
  EXPECT_NE(document("<key qpos='0.2 0 0'/>"), document(""));
}

TEST(Mjcf, JointsOfActuatorsAndSpringsStayIndependent) {
  const std::string loop = "<connect body1='bar' body2='rocker' anchor='0 2 0'/>";
  const auto coordinate = [&](const std::string& after, const std::string& pin = "") {
    const model::KinematicTree tree = tree_of(four_bar(loop, after, pin));
    return tree.dof() == 1 ? tree.joints[static_cast<std::size_t>(tree.coordinates()[0])].name : "";
  };
  EXPECT_EQ(coordinate(""), "turn");
  EXPECT_EQ(coordinate("<actuator><motor joint='rock'/></actuator>"), "rock");
  EXPECT_EQ(coordinate("", "stiffness='3'"), "pin");
  EXPECT_EQ(
      coordinate("<tendon><fixed name='t'><joint joint='pin' coef='1'/></fixed></tendon><actuator><motor tendon='t'/>"
                 "</actuator>"),
      "pin");
}

TEST(Mjcf, BallJointsInLoopsBecomeHinges) {
  const model::KinematicTree tree =
      tree_of(four_bar("<connect body1='bar' body2='rocker' anchor='0 2 0'/>", "", "type='ball'"));
  std::vector<std::string> names;
  for (const model::Joint& joint : tree.joints) names.push_back(joint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"turn", "pin_1", "pin_2", "pin_3", "rock"}));
  EXPECT_EQ(tree.dof(), 2);
  // The last hinge is along the rod: no loop moves it.
  EXPECT_EQ(tree.coupling_of(3), nullptr);
  const model::KinematicTree apart = tree_of(four_bar("", "", "type='ball'"));
  EXPECT_EQ(apart.spherical_joints().size(), 1U);
}

TEST(Mjcf, CopiesHaveLoopsOfTheirOwn) {
  const model::KinematicTree tree = tree_of(
      std::string("<mujoco><worldbody><replicate count='2' offset='0 0 1'><body name='crank'><joint name='turn'/>") +
      kInertial + "<body name='bar' pos='1 0 0'><joint name='pin'/>" + kInertial +
      "</body></body><body name='rocker' " + "pos='3 1 0'><joint name='rock'/>" + kInertial +
      "</body></replicate></worldbody><equality>" +
      "<connect body1='bar' body2='rocker' anchor='0 2 0'/></equality></mujoco>");
  ASSERT_EQ(tree.loops.size(), 2U);
  EXPECT_EQ(tree.dof(), 2);
  for (std::size_t k = 0; k < 2; ++k)
    for (const model::LoopEnd& end : tree.loops[k].ends)
      EXPECT_TRUE(tree.links[static_cast<std::size_t>(end.link)].name.ends_with(k == 0 ? "0" : "1"));
}

TEST(Mjcf, StraightTendonsAreActuatorsOrDistances) {
  const std::string tendon = "<tendon><spatial name='rope'><site site='end'/><site site='eye'/></spatial></tendon>";
  const model::KinematicTree pulled =
      tree_of(four_bar("", tendon + "<actuator><motor tendon='rope'/><position tendon='rope'/></actuator>"));
  ASSERT_EQ(pulled.actuators.size(), 1U);
  EXPECT_EQ(pulled.actuators[0].name, "rope");
  EXPECT_EQ(pulled.actuators[0].frames, (std::array<std::string, 2>{"end", "eye"}));
  EXPECT_TRUE(tree_of(four_bar("", tendon)).actuators.empty());
  const std::string rope = "<tendon><spatial name='rope'><site site='end'/><site site='post'/></spatial></tendon>";
  const model::KinematicTree rod = tree_of(
      std::string("<mujoco><worldbody><site name='post' pos='1 2 4'/><body><joint name='j'/>") + kInertial +
      "<body><joint name='k'/>" + kInertial + "<site name='end' pos='1 0 2'/></body></body></worldbody>" + rope +
      "<equality><tendon tendon1='rope' polycoef='0.25'/></equality></mujoco>");
  ASSERT_EQ(rod.loops.size(), 1U);
  EXPECT_EQ(rod.loops[0].type, model::LoopType::distance);
  EXPECT_NEAR(model::evaluate(rod.loops[0].length), std::sqrt(8.0) + 0.25, 1e-15);
}

TEST(Mjcf, EqualitiesOfFixedTendonsAreCouplings) {
  const auto document = [](const std::string& equality) {
    return coupled(
        "<tendon><fixed name='s'><joint joint='a' coef='2'/></fixed><fixed name='t'><joint joint='b' coef='4'/>"
        "</fixed></tendon>",
        equality);
  };
  EXPECT_EQ(
      robot_document(document("<tendon tendon1='t' tendon2='s' polycoef='0.4 3'/>")),
      robot_document(document("<joint joint1='b' joint2='a' polycoef='0.1 1.5'/>")));
  EXPECT_EQ(
      robot_document(document("<tendon tendon1='t' polycoef='0.4'/>")),
      robot_document(document("<joint joint1='b' polycoef='0.1'/>")));
}

// tests/oracles/mjcf/elastic.xml compares their forces with MuJoCo.
TEST(Mjcf, SpringsOfFixedTendons) {
  const auto tendons = [](const std::string& attributes) {
    return tree_of(
               std::string("<mujoco><default><default class='soft'><tendon stiffness='2'/></default></default>"
                           "<worldbody><body><joint name='a' ref='30' springref='20'/>") +
               kInertial + "</body><replicate count='2'><body><joint name='b'/>" + kInertial +
               "</body></replicate></worldbody><tendon><fixed " + attributes +
               "><joint joint='a' coef='3'/><joint joint='b' coef='-1'/></fixed></tendon></mujoco>")
        .tendons;
  };
  EXPECT_TRUE(tendons("name='t' range='0 1'").empty());
  // One for each copy; at rest where the joints are at their spring references.
  const std::vector<model::Tendon> drawn = tendons("name='t' class='soft' damping='0.5 0 0'");
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_EQ(drawn[0].name, "t");
  EXPECT_EQ(drawn[1].name, "t_2");
  EXPECT_EQ(model::evaluate(drawn[0].stiffness), 2.0);
  EXPECT_EQ(model::evaluate(drawn[0].damping), 0.5);
  EXPECT_NEAR(model::evaluate(drawn[0].rest), 3 * std::acos(-1.0) / 9, 1e-15);
  ASSERT_EQ(drawn[1].terms.size(), 2U);
  EXPECT_EQ(drawn[0].terms[1].joint, 1);
  EXPECT_EQ(drawn[1].terms[1].joint, 2);
  EXPECT_EQ(model::evaluate(drawn[1].terms[0].factor), 3.0);
  // A length is not an angle, whatever the unit of angles.
  EXPECT_EQ(model::evaluate(tendons("stiffness='1' springlength='0.25'")[0].rest), 0.25);
  EXPECT_EQ(model::evaluate(tendons("stiffness='1' springlength='0.25 0.25'")[0].rest), 0.25);
}

}  // namespace
}  // namespace robcogen::mjcf_content_test
