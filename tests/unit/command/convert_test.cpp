// The subcommand convert: pairs of languages, written files, refused requests.
#include <gtest/gtest.h>

#include "run_tool.h"

namespace robcogen::test::convert_test {
namespace {

namespace fs = std::filesystem;

const char* const kParametric =
    "Robot Arm { RobotBase base { children { upper via shoulder } } link upper { id = 1 inertia_params { mass = 1.0 "
    "CoM = (0.0, 0.0, 0.0) Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children { } } r_joint shoulder { ref_frame "
    "{ translation = (reach, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }";

TEST(Convert, MakesAUrdfAndBackOfARobotDocument) {
  const Scratch scratch("convert");
  const fs::path urdf = scratch.path / "hyl.urdf", back = scratch.path / "hyl.kindsl", again = scratch.path / "2.urdf";
  ASSERT_EQ(run_tool("convert " + quoted(robot("hyl")) + " " + quoted(urdf)).status, 0);
  EXPECT_NE(read_text(urdf).find("<robot name=\"HyL\">"), std::string::npos);
  ASSERT_EQ(run_tool("convert " + quoted(urdf) + " " + quoted(back)).status, 0);
  EXPECT_NE(read_text(back).find("p_joint SLIDE"), std::string::npos);
  EXPECT_EQ(read_text(back).find("// Converted from hyl.urdf."), 0U) << read_text(back);
  ASSERT_EQ(run_tool("check --strict " + quoted(back)).status, 0);
  ASSERT_EQ(run_tool("convert " + quoted(urdf) + " " + quoted(again)).status, 0);
  // Moving inertias to the link's origin and back causes rounding; poses stay unchanged.
  const auto joints = [](const fs::path& file) {
    const std::string text = read_text(file);
    return text.substr(text.find("<joint"));
  };
  EXPECT_EQ(joints(again), joints(urdf));
}

TEST(Convert, MakesMotionsOfARobotAndTransformsOfBoth) {
  const Scratch scratch("motions");
  const fs::path motions = scratch.path / "hyl.motdsl", transforms = scratch.path / "hyl.ctdsl";
  ASSERT_EQ(run_tool("convert " + quoted(robot("hyl")) + " " + quoted(motions)).status, 0);
  // Fig. 9 of the paper, with full names.
  EXPECT_NE(
      read_text(motions).find("fr_slider -> fr_HFE : try(0.13) trz(-0.08) rotx(-PI/2.0) rotz(PI/2.0)\n"
                              "fr_HFE -> fr_upperleg : rotz(q_HFE)\n"),
      std::string::npos)
      << read_text(motions);

  ASSERT_EQ(run_tool("convert " + quoted(motions) + " " + quoted(transforms)).status, 0);
  EXPECT_NE(read_text(transforms).find("{fr_HFE}_X_{fr_upperleg} = Rz(q_HFE)\n"), std::string::npos);
  EXPECT_NE(read_text(transforms).find("{fr_upperleg}_X_{fr_HFE} = Rz(-q_HFE)\n"), std::string::npos);
  EXPECT_NE(read_text(transforms).find("TransformedFramePos = right\n"), std::string::npos);

  const fs::path list = scratch.path / "list.dtdsl";
  write_text(list, "Model HyL Frames { fr_base, fr_upperleg } Transforms { base=fr_upperleg, target=fr_base }");
  const std::string expected = "Tz(-q_SLIDE)\n";
  for (const fs::path& from : {motions, robot("hyl")}) {
    ASSERT_EQ(run_tool("convert --desired " + quoted(list) + " " + quoted(from) + " " + quoted(transforms)).status, 0);
    const std::string text = read_text(transforms);
    EXPECT_EQ(text.substr(text.size() - expected.size()), expected) << text;
  }
  ASSERT_EQ(run_tool("convert --position left " + quoted(motions) + " " + quoted(transforms)).status, 0);
  EXPECT_NE(read_text(transforms).find("{fr_HFE}_X_{fr_upperleg} = Rz(-q_HFE)\n"), std::string::npos);
}

// A document is read only once. Names that would collide in generated code are allowed in a document of motions.
TEST(Convert, SaysOnceWhatIsOddAboutMotions) {
  const Scratch scratch("odd_motions");
  const fs::path motions = scratch.path / "arm.motdsl", transforms = scratch.path / "arm.ctdsl";
  write_text(
      motions, "Model Arm Convention = local base -> elbow : rotz(400.0) [hand_X_elbow] elbow -> hand : roty(bend)");
  const Outcome run = run_tool("convert " + quoted(motions) + " " + quoted(transforms));
  EXPECT_EQ(run.status, 0) << run.errors;
  const std::size_t first = run.errors.find("[large-angle]");
  ASSERT_NE(first, std::string::npos) << run.errors;
  EXPECT_EQ(run.errors.find("[large-angle]", first + 1), std::string::npos) << run.errors;
  EXPECT_NE(read_text(transforms).find("Ry(bend)"), std::string::npos);
  EXPECT_EQ(run_tool("convert --strict " + quoted(motions) + " " + quoted(transforms)).status, 1);
}

TEST(Convert, RefusesWhatALanguageCannotSay) {
  const Scratch scratch("parametric");
  const fs::path model = scratch.path / "arm.kindsl", urdf = scratch.path / "arm.urdf";
  write_text(model, kParametric);
  const Outcome run = run_tool("convert " + quoted(model) + " " + quoted(urdf));
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("reach"), std::string::npos) << run.errors;
  EXPECT_FALSE(fs::exists(urdf));
  // Documents of motions may have parameters.
  const fs::path motions = scratch.path / "arm.motdsl";
  EXPECT_EQ(run_tool("convert " + quoted(model) + " " + quoted(motions)).status, 0);
  EXPECT_NE(read_text(motions).find("trx(lengths.reach)"), std::string::npos) << read_text(motions);
}

TEST(Convert, RefusesLoopsWhereALanguageHasNone) {
  const Scratch scratch("loops");
  for (const char* to : {"five_bar.motdsl", "five_bar.ctdsl"}) {
    const Outcome refused = run_tool("convert " + quoted(robot("five_bar")) + " " + quoted(scratch.path / to));
    EXPECT_EQ(refused.status, 1) << to;
    EXPECT_NE(refused.errors.find("but robot 'FiveBar' has loop 'tip' [loop-lost]"), std::string::npos)
        << refused.errors;
    EXPECT_FALSE(fs::exists(scratch.path / to));
  }
}

TEST(Convert, WritesHingesToUrdf) {
  const Scratch scratch("hinges");
  const fs::path urdf = scratch.path / "five_bar.urdf";
  const Outcome written = run_tool("convert " + quoted(robot("five_bar")) + " " + quoted(urdf));
  EXPECT_EQ(written.status, 0) << written.errors;
  EXPECT_NE(written.errors.find("[urdf-plus]"), std::string::npos) << written.errors;
  EXPECT_NE(read_text(urdf).find("<loop name=\"tip\""), std::string::npos);
  EXPECT_EQ(run_tool("check " + quoted(urdf)).status, 0);
  // Rods of a fixed length are not written.
  const fs::path other = scratch.path / "leg.urdf";
  const Outcome refused = run_tool("convert " + quoted(robot("achilles_leg")) + " " + quoted(other));
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.errors.find("is of type distance [loop-lost]"), std::string::npos) << refused.errors;
  EXPECT_FALSE(fs::exists(other));
}

TEST(Convert, KeepsLimits) {
  const Scratch scratch("limits");
  const fs::path urdf = scratch.path / "arm.urdf";
  write_text(
      urdf,
      "<robot name='arm'><link name='base'/><link name='upper'><inertial><mass value='1'/><inertia ixx='1' ixy='0' "
      "ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link><joint name='shoulder' type='revolute'><parent link='base'/>"
      "<child link='upper'/><axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='5' velocity='2'/></joint></robot>");
  const Outcome run = run_tool("convert " + quoted(urdf) + " " + quoted(scratch.path / "arm.kindsl"));
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(
      read_text(scratch.path / "arm.kindsl").find("limits { position = (-1.0, 1.0) velocity = 2.0 effort = 5.0 }"),
      std::string::npos);
  EXPECT_EQ(
      run_tool("convert " + quoted(scratch.path / "arm.kindsl") + " " + quoted(scratch.path / "2.urdf")).status, 0);
  EXPECT_NE(read_text(scratch.path / "2.urdf").find("effort=\"5.0\""), std::string::npos);
}

// A robot document gives both bounds of a position, and so does a URDF. A negative effort means no limit.
TEST(Convert, KeepsALimitOnOneSide) {
  const Scratch scratch("one_sided_limit");
  const fs::path urdf = scratch.path / "arm.urdf", document = scratch.path / "arm.kindsl",
                 again = scratch.path / "2.urdf";
  write_text(
      urdf,
      "<robot name='arm'><link name='base'/><link name='upper'><inertial><mass value='1'/><inertia ixx='1' ixy='0' "
      "ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link><joint name='shoulder' type='revolute'><parent link='base'/>"
      "<child link='upper'/><axis xyz='0 0 1'/><limit lower='-2e9' upper='1' effort='-1' velocity='2'/></joint>"
      "</robot>");
  ASSERT_EQ(run_tool("convert --strict " + quoted(urdf) + " " + quoted(document)).status, 0);
  const Outcome run = run_tool("convert --strict " + quoted(document) + " " + quoted(again));
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(read_text(again).find("<limit lower=\"-1e+09\" upper=\"1.0\""), std::string::npos) << read_text(again);
}

TEST(Convert, NamesWhatAUrdfCannotSayOfDrives) {
  const Scratch scratch("drives");
  const fs::path urdf = scratch.path / "leg.urdf", back = scratch.path / "leg.kindsl";
  const Outcome run = run_tool("convert " + quoted(robot("geared_leg")) + " " + quoted(urdf));
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.errors.find("left out: rotor of 'HAA', velocity of the friction of 'HAA', "), std::string::npos)
      << run.errors;
  EXPECT_NE(run.errors.find("[drive-lost]"), std::string::npos) << run.errors;
  EXPECT_NE(read_text(urdf).find("<dynamics damping=\"0.02\" friction=\"0.3\"/>"), std::string::npos);
  const Outcome again = run_tool("convert " + quoted(urdf) + " " + quoted(back));
  EXPECT_NE(again.errors.find("[passive-forces-used]"), std::string::npos) << again.errors;
  EXPECT_NE(read_text(back).find("        damping = 0.02\n        friction = 0.3\n"), std::string::npos);
}

TEST(Convert, NamesTheActuatorsThatAUrdfHasNot) {
  const Scratch scratch("actuators");
  const fs::path urdf = scratch.path / "leg.urdf";
  const Outcome run = run_tool("convert " + quoted(robot("four_bar_leg")) + " " + quoted(urdf));
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(
      run.errors.find(
          "warning: a URDF has no actuators between frames; these are left out: 'hip_cylinder', 'knee_cylinder' "
          "[actuator-lost]"),
      std::string::npos)
      << run.errors;
}

TEST(Convert, WrongUrdfExitsWithOneAndWritesNothing) {
  const Scratch scratch("wrong-urdf");
  const fs::path urdf = scratch.path / "bad.urdf", out = scratch.path / "bad.kindsl";
  write_text(urdf, "<robot name='r'>\n  <link name='a'/>\n  <link name='b'/>\n</robot>\n");
  const Outcome run = run_tool("convert " + quoted(urdf) + " " + quoted(out));
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("bad.urdf:"), std::string::npos) << run.errors;
  EXPECT_FALSE(fs::exists(out));
}

TEST(Convert, UsageFaultsExitWithTwo) {
  const Scratch scratch("usage");
  const fs::path motions = scratch.path / "m.motdsl";
  write_text(motions, "Model M Convention = local A -> B : rotx(q)");
  const fs::path scene = scratch.path / "scene.xml";
  write_text(scene, "<mujoco><worldbody/></mujoco>");
  const std::string m = quoted(motions), out = quoted(scratch.path / "out"), hyl = quoted(robot("hyl"));
  for (const std::string& arguments : std::vector<std::string>{
           "convert", "convert " + hyl, "convert " + hyl + " out.txt", "convert no-such-file.kindsl out.urdf",
           "convert " + hyl + " out.kindsl", "convert " + m + " out.urdf", "convert " + m + " out.kindsl",
           "convert " + m + " out.motdsl", "convert --floating-base " + hyl + " out.urdf",
           "convert --desired x.dtdsl " + hyl + " out.urdf", "convert --position up " + m + " out.ctdsl",
           "convert " + m + " " + quoted(motions / "below" / "a.ctdsl"), "ops --snap-angles " + hyl,
           "check --snap-angles " + hyl, "check --robot arm " + hyl, "check --floating-base " + quoted(scene),
           "eval --floating-base " + quoted(scene) + " joint_space_inertia"}) {
    const Outcome run = run_tool(arguments);
    EXPECT_EQ(run.status, 2) << arguments << "\n" << run.errors;
    EXPECT_NE(run.errors.find("error"), std::string::npos) << arguments;
    EXPECT_EQ(run.output, "") << arguments;
  }
}

}  // namespace
}  // namespace robcogen::test::convert_test
