// Drawings and pages from the command line.
#include <gtest/gtest.h>

#include "run_tool.h"

namespace robcogen::test::view_test {
namespace {

namespace fs = std::filesystem;

fs::path robot(const std::string& name) {
  return fs::path(ROBCOGEN_ROBOTS_DIR) / name / (name + ".kindsl");
}

TEST(Draw, WritesADrawing) {
  const Scratch scratch("draw");
  const fs::path svg = scratch.path / "new" / "hyl.svg";
  const Outcome run = run_tool("draw " + quoted(robot("hyl")) + " -o " + quoted(svg) + " --q 0.1,0.2,-0.3");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output, "");
  const std::string text = read_text(svg);
  EXPECT_EQ(text.find("<svg xmlns"), 0U);
  EXPECT_EQ(text.find("inertia matrix"), std::string::npos);
  const fs::path other = scratch.path / "other.svg";
  run_tool("draw " + quoted(robot("hyl")) + " -o " + quoted(other) + " --pattern --q KFE=-0.3,HFE=0.2,SLIDE=0.1");
  const std::string with_pattern = read_text(other);
  EXPECT_NE(with_pattern.find("inertia matrix"), std::string::npos);
  // The robot is the same, in the position that is given by name.
  const std::size_t first = text.find("<polygon"), last = text.rfind("</text>");
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(with_pattern.find(text.substr(first, text.rfind("<text", last) - first)), std::string::npos);
}

TEST(Draw, PlainlyHasJointsAndNoWords) {
  const Scratch scratch("draw-plain");
  const std::string command = "draw " + quoted(robot("hyl")) + " -o " + quoted(scratch.path / "hyl.svg") + " --plain";
  EXPECT_EQ(run_tool(command).status, 0);
  const std::string text = read_text(scratch.path / "hyl.svg");
  EXPECT_NE(text.find("class=\"hub\""), std::string::npos);
  EXPECT_EQ(text.find("<text"), std::string::npos);
  EXPECT_LT(text.size(), 4000U);
  const Outcome both = run_tool(command + " --pattern");
  EXPECT_EQ(both.status, 2);
  EXPECT_NE(both.errors.find("--pattern excludes --plain"), std::string::npos) << both.errors;
}

// Positions are given by the names of their elements; a quaternion of any length but zero is a rotation.
TEST(Draw, TakesQuaternions) {
  const Scratch scratch("draw-spherical");
  const std::string leg = quoted(robot("ball_leg")), picture = quoted(scratch.path / "picture");
  const auto drawn = [&](const std::string& q) {
    const Outcome run = run_tool("draw " + leg + " -o " + picture + q);
    EXPECT_EQ(run.status, 0) << run.errors;
    return read_text(scratch.path / "picture");
  };
  const std::string quarter = drawn(" --q hip_y=1,knee=0.5");
  EXPECT_EQ(quarter, drawn(" --q 0.5,0,0.5,0,0.5,1,0,0,0"));
  EXPECT_NE(quarter, drawn(" --q knee=0.5"));
  for (const char* q : {"hip_w=0", "0,0,0,0,0.5,1,0,0,0"}) {
    const Outcome run = run_tool("draw " + leg + " -o " + picture + " --q " + q);
    EXPECT_EQ(run.status, 2) << q;
    EXPECT_NE(run.errors.find("--q: the quaternion of hip_w to hip_z has no direction"), std::string::npos)
        << run.errors;
  }
}

TEST(Draw, SaysWhatIsWrongWithNumbers) {
  const Scratch scratch("draw-wrong");
  const std::string draw = "draw " + quoted(robot("hyl")) + " -o " + quoted(scratch.path / "a.svg") + " ";
  const auto errors = [&](const std::string& options) {
    const Outcome run = run_tool(draw + options);
    EXPECT_EQ(run.status, 2) << options;
    EXPECT_FALSE(fs::exists(scratch.path / "a.svg"));
    return run.errors;
  };
  EXPECT_EQ(
      errors("--q 0.1,0.2"),
      "robcogen: error: --q: 2 numbers are given, but the robot has 3\nhint: they are those of SLIDE, HFE, KFE; or "
      "name "
      "them: SLIDE=0.5\n");
  EXPECT_EQ(
      errors("--q KFF=0.1"), "robcogen: error: --q: 'KFF' is not one of SLIDE, HFE, KFE\nhint: did you mean 'KFE'?\n");
  EXPECT_EQ(errors("--q KFE=1.0x"), "robcogen: error: --q: '1.0x' is not a finite decimal number\n");
  EXPECT_EQ(errors("--q KFE=nan"), "robcogen: error: --q: 'nan' is not a finite decimal number\n");
  EXPECT_EQ(errors("--q KFE=1,2"), "robcogen: error: --q: '2' has no name, but other values have one\n");
  EXPECT_EQ(run_tool("draw " + quoted(robot("hyl"))).errors, "robcogen: error: draw needs an output file: -o FILE\n");
  const fs::path euler = fs::path(ROBCOGEN_ROBOTS_DIR) / "euler" / "euler.motdsl";
  EXPECT_EQ(
      run_tool("draw " + quoted(euler) + " -o a.svg").errors,
      "robcogen: error: draw applies to robots only, not to motions and transforms\n");
}

TEST(Draw, RefusesOtherFormats) {
  const Scratch scratch("draw-other");
  const fs::path png = scratch.path / "a.png", svg = scratch.path / "a.SVG";
  EXPECT_EQ(
      run_tool("draw " + quoted(robot("hyl")) + " -o " + quoted(png)).errors,
      "robcogen: error: draw writes svg, not '.png': " + png.string() + "\nhint: name a file that ends in .svg\n");
  EXPECT_FALSE(fs::exists(png));
  EXPECT_EQ(run_tool("draw " + quoted(robot("hyl")) + " -o " + quoted(svg)).status, 0);
  const Outcome run = run_tool("view " + quoted(robot("hyl")) + " -o " + quoted(png));
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.errors.find("hint: name a file that ends in .html or .htm\n"), std::string::npos) << run.errors;
}

TEST(View, WritesAPage) {
  const Scratch scratch("view");
  const fs::path page = scratch.path / "new" / "hyl.html";
  const Outcome run = run_tool("view " + quoted(robot("hyl")) + " -o " + quoted(page) + " --q KFE=-0.5");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output, "");
  EXPECT_EQ(read_text(page).find("<!DOCTYPE html>"), 0U);
  EXPECT_EQ(run_tool("view " + quoted(robot("hyl"))).status, 2);
  const fs::path wrong = scratch.path / "wrong.kindsl", none = scratch.path / "none.html";
  write_text(wrong, "Robot r {");
  EXPECT_EQ(run_tool("view " + quoted(wrong) + " -o " + quoted(none)).status, 1);
  EXPECT_FALSE(fs::exists(none));
}

TEST(Draw, AsksForParametersWithoutValue) {
  const Scratch scratch("draw-parameters");
  const fs::path model = scratch.path / "arm.kindsl", svg = scratch.path / "arm.svg";
  write_text(
      model,
      "Robot Arm { RobotBase base { children { upper via j } }\n"
      "link upper { id = 1 inertia_params { mass = m CoM = (0.0, 0.0, len) Ix = 0.5 Iy = 0.5 Iz = 0.4 Ixy = 0.0\n"
      "Ixz = 0.0 Iyz = 0.0 } children {} }\n"
      "r_joint j { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }\n");
  const std::string draw = "draw " + quoted(model) + " -o " + quoted(svg);
  const Outcome without = run_tool(draw);
  EXPECT_EQ(without.status, 2);
  EXPECT_NE(without.errors.find("error: --parameters: these parameters have no value: "), std::string::npos)
      << without.errors;
  EXPECT_FALSE(fs::exists(svg));
  const Outcome with = run_tool(draw + " --parameters len=0.3,m=2");
  EXPECT_EQ(with.status, 0) << with.errors;
  EXPECT_TRUE(fs::exists(svg));
}

TEST(Draw, NamesWhatItRead) {
  const Scratch scratch("draw-depfile");
  const fs::path svg = scratch.path / "h.svg", depfile = scratch.path / "h.d";
  const Outcome run = run_tool(
      "draw " + quoted(robot("quadruped")) + " -o " + quoted(svg) + " --depfile " + quoted(depfile) +
      " --azimuth 30 --elevation -10");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(read_text(depfile).find("quadruped.kindsl"), std::string::npos);
  EXPECT_TRUE(read_text(svg).ends_with("</svg>\n"));
}

}  // namespace
}  // namespace robcogen::test::view_test
