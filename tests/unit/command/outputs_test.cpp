// No subcommand writes over a file that it reads, whatever path or link leads to it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "run_tool.h"

namespace robcogen::test::outputs_test {
namespace {

namespace fs = std::filesystem;

const std::string kArmLink =
    "<link name=\"arm\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
    "izz=\"1\"/></inertial><visual><geometry><sphere radius=\"0.1\"/></geometry></visual></link>";
const std::string kArmUrdf =
    "<robot name=\"r\"><link name=\"base\"/>" + kArmLink +
    "<joint name=\"j\" type=\"continuous\"><parent link=\"base\"/><child link=\"arm\"/></joint></robot>";
const std::string kRobotWithPart = "import \"part.kindsl\"\nRobot r { RobotBase base { children { Limb l() } } }\n";
const std::string kLimbPart =
    "Part Limb { root arm via j link arm { inertia_params { mass = 1.0 CoM = (0.1, 0.0, 0.0) Ix = 1.0 Iy = 1.0 "
    "Iz = 1.0 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children {} } "
    "r_joint j { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }\n";

// A folder with one model of each kind, and the files that the models refer to.
class Outputs : public testing::Test {
 protected:
  const Scratch scratch_{"outputs"};

  void SetUp() override {
    put("arm.urdf", kArmUrdf);
    put("robot.kindsl", kRobotWithPart);
    put("part.kindsl", kLimbPart);
    put("list.dtdsl", "Robot r Frames { fr_base, fr_l_arm } Transforms { fr_base <- fr_l_arm }\n");
    put("m.motdsl", "Model m Convention = local a -> b : rotx(q)\n");
    put("m.dtdsl", "Model m Frames { a, b } Transforms { a <- b }\n");
    put("world.xml", "<mujoco><worldbody><include file=\"body.xml\"/></worldbody></mujoco>");
    put("body.xml",
        "<mujocoinclude><body name=\"b\"><joint name=\"j\" type=\"hinge\"/><geom type=\"sphere\" size=\"0.1\"/>"
        "</body></mujocoinclude>");
    put("states.json", "{\"q\": [0.1]}\n{\"q\": [0.2]}\n");
  }
  void put(const std::string& name, const std::string& text) { write_text(scratch_.path / name, text); }
  std::string get(const std::string& name) const { return read_text(scratch_.path / name); }

  // Runs the tool in the folder. `redirection` overrides those of run_tool.
  Outcome run(const std::string& arguments, const std::string& redirection = "") const {
    return run_tool(arguments, "", "f() { cd " + quoted(scratch_.path) + " && \"$@\" " + redirection + "; }; f");
  }
  static void expect_refused(const Outcome& run, const std::string& command) {
    EXPECT_EQ(run.status, 2) << command << "\n" << run.errors;
    EXPECT_NE(run.errors.find("the output would replace the input: "), std::string::npos) << command << run.errors;
    EXPECT_NE(run.errors.find("[output-is-input]\nhint: name another output\n"), std::string::npos) << run.errors;
  }
};

struct OutputRow {
  const char* command;    // OUT is the output
  const char* input;      // the file that OUT is
  const char* extension;  // of OUT
};

// Options that name an output, and each kind of file that is read.
const OutputRow kOutputRows[] = {
    {"convert arm.urdf OUT", "arm.urdf", ".urdf"},
    {"convert arm.urdf OUT", "arm.urdf", ".kindsl"},
    {"convert robot.kindsl OUT", "part.kindsl", ".urdf"},
    {"convert robot.kindsl OUT --desired list.dtdsl", "list.dtdsl", ".ctdsl"},
    {"convert m.motdsl OUT", "m.motdsl", ".ctdsl"},
    {"convert m.motdsl OUT --desired m.dtdsl", "m.dtdsl", ".ctdsl"},
    {"convert world.xml OUT", "body.xml", ".kindsl"},
    {"draw arm.urdf -o OUT", "arm.urdf", ".svg"},
    {"draw world.xml -o OUT", "body.xml", ".svg"},
    {"draw arm.urdf -o a.svg --depfile OUT", "arm.urdf", ""},
    {"view arm.urdf -o OUT", "arm.urdf", ".html"},
    {"view robot.kindsl -o a.html --depfile OUT", "part.kindsl", ".d"},
    {"generate arm.urdf -o out --effort 0 --algorithms energy --depfile OUT", "arm.urdf", ".d"},
    {"generate arm.urdf -o out --effort 0 --algorithms energy --stamp OUT", "arm.urdf", ""},
    {"generate robot.kindsl -o out --effort 0 --algorithms energy --stamp OUT", "part.kindsl", ""},
    {"generate robot.kindsl -o out --effort 0 --algorithms energy --desired list.dtdsl --stamp OUT", "list.dtdsl", ""},
    {"generate m.motdsl -o out --desired m.dtdsl --stamp OUT", "m.dtdsl", ""},
};

TEST_F(Outputs, ReplaceGeneratedFilesOnly) {
  const std::string command = "generate arm.urdf -o out --effort 0 --algorithms energy";
  fs::create_directories(scratch_.path / "out/arm");
  put("out/arm/energy.cpp", "// my own energy\n");
  const Outcome refused = run(command);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(
      refused.errors.find(
          "robcogen: error: a generated file would replace 'out/arm/energy.cpp', which was not generated "
          "[output-is-not-generated]\nhint: "),
      std::string::npos)
      << refused.errors;
  EXPECT_EQ(get("out/arm/energy.cpp"), "// my own energy\n");
  EXPECT_FALSE(fs::exists(scratch_.path / "out/arm/arm.h"));
  // Files that are empty, generated or generated and then edited are replaced.
  for (const std::string text : {"", "// generated by robcogen from an older arm.urdf\n"}) {
    put("out/arm/energy.cpp", text);
    EXPECT_EQ(run(command).status, 0);
    EXPECT_NE(get("out/arm/energy.cpp"), text);
  }
}

TEST_F(Outputs, AreNeverInputs) {
  const std::vector<std::string> kinds = ROBCOGEN_TEST_EVERYTHING
                                             ? std::vector<std::string>{"soft", "hard", "behind a folder"}
                                             : std::vector<std::string>{"hard"};
  for (const OutputRow& row : kOutputRows)
    for (const std::string& kind : kinds) {
      const std::string before = get(row.input);
      fs::path out = scratch_.path / ("output" + std::string(row.extension));
      fs::remove(out);
      fs::create_directories(scratch_.path / "folder");
      if (kind == "hard") {
        fs::create_hard_link(scratch_.path / row.input, out);
      } else if (kind == "soft") {
        fs::create_symlink(row.input, out);
      } else {
        if (fs::path(row.input).extension() != row.extension && *row.extension != '\0') continue;
        out = scratch_.path / "folder" / ".." / row.input;
      }
      std::string command = row.command;
      command.replace(command.find("OUT"), 3, out.string());
      expect_refused(run(command), command);
      EXPECT_EQ(get(row.input), before) << kind << ": " << command;
      for (const char* other : {"out", "a.svg", "a.html"}) EXPECT_FALSE(fs::exists(scratch_.path / other)) << command;
      fs::remove(scratch_.path / ("output" + std::string(row.extension)));
    }
}

// Names of generated files follow from the options, and files of an earlier run are removed.
TEST_F(Outputs, OfGenerateAreNeverInputs) {
  const std::string options = " --effort 0 --algorithms energy -o out --name r ";
  fs::create_directories(scratch_.path / "out" / "r");
  put("out/r/r.h", kArmUrdf);
  expect_refused(run("generate out/r/r.h" + options), "generate out/r/r.h");
  EXPECT_EQ(get("out/r/r.h"), kArmUrdf);
  put("out/model.urdf", kArmUrdf);
  fs::create_directories(scratch_.path / "out" / "matlab");
  put("out/matlab/r.files", "model.urdf\n");
  const Outcome kept = run("generate out/model.urdf --language matlab" + options);
  EXPECT_EQ(kept.status, 0) << kept.errors;
  EXPECT_EQ(get("out/model.urdf"), kArmUrdf);
}

TEST_F(Outputs, OnStandardOutputAreNeverInputs) {
  const std::pair<const char*, const char*> commands[] = {
      {"print robot.kindsl", "robot.kindsl"},
      {"print --expand robot.kindsl", "part.kindsl"},
      {"print robot.kindsl --program energy", "part.kindsl"},
      {"print m.motdsl", "m.motdsl"},
      {"ops arm.urdf --algorithms energy", "arm.urdf"},
      {"ops world.xml --algorithms energy --json", "body.xml"},
      {"ops robot.kindsl --desired list.dtdsl", "list.dtdsl"},
      {"generate arm.urdf --list-outputs", "arm.urdf"},
      {"eval arm.urdf gravity_forces", "arm.urdf"},
      {"eval world.xml gravity_forces", "body.xml"}};
  for (const auto& [command, input] : commands) {
    const std::string before = get(input);
    fs::create_symlink(input, scratch_.path / "link");
    expect_refused(run(command, ">> link"), command);
    EXPECT_EQ(get(input), before) << command;
    fs::remove(scratch_.path / "link");
  }
  // The states that are evaluated: results would be read as further states.
  const std::string states = get("states.json");
  expect_refused(run("eval arm.urdf gravity_forces", "< states.json >> states.json"), "eval");
  EXPECT_EQ(get("states.json"), states);
  expect_refused(run("convert - arm.urdf", "< arm.urdf"), "convert -");
  EXPECT_EQ(get("arm.urdf"), kArmUrdf);
}

TEST_F(Outputs, OfOneCommandAreDifferentFiles) {
  for (const char* command :
       {"draw arm.urdf -o a.svg --depfile ./a.svg", "view arm.urdf -o a.html --depfile a.html",
        "generate arm.urdf -o out --effort 0 --algorithms energy --depfile x --stamp x",
        "generate arm.urdf -o out --effort 0 --algorithms energy --stamp out/arm/arm.h"}) {
    const Outcome refused = run(command);
    EXPECT_EQ(refused.status, 2) << command;
    EXPECT_NE(refused.errors.find("are the same file [outputs-coincide]"), std::string::npos) << refused.errors;
    for (const char* name : {"out", "a.svg", "a.html", "x"}) EXPECT_FALSE(fs::exists(scratch_.path / name)) << command;
  }
}

// What is not an input is written: a link remains a link, and a pipe remains a pipe.
TEST_F(Outputs, MayBeLinksAndStreams) {
  put("store.kindsl", "old");
  fs::create_symlink("store.kindsl", scratch_.path / "link.kindsl");
  EXPECT_EQ(run("convert arm.urdf link.kindsl").status, 0);
  EXPECT_TRUE(fs::is_symlink(scratch_.path / "link.kindsl"));
  EXPECT_EQ(get("store.kindsl").find("// Converted from arm.urdf."), 0U) << get("store.kindsl");
  const Outcome plain = run("draw arm.urdf -o drawing.svg");
  EXPECT_EQ(plain.status, 0) << plain.errors;
  EXPECT_EQ(run("draw arm.urdf -o /dev/stdout", "| cat > piped.svg").status, 0);
  EXPECT_EQ(get("piped.svg"), get("drawing.svg"));
  EXPECT_EQ(run("draw arm.urdf -o /dev/stdout", "> redirected.svg").status, 0);
  EXPECT_EQ(get("redirected.svg"), get("drawing.svg"));
  ASSERT_EQ(::mkfifo((scratch_.path / "pipe").c_str(), 0600), 0);
  const std::string read =
      "& timeout 60 cat " + quoted(scratch_.path / "pipe") + " > " + quoted(scratch_.path / "read.svg");
  EXPECT_EQ(run("draw arm.urdf -o pipe", read + "; wait $!").status, 0);
  EXPECT_TRUE(fs::is_fifo(scratch_.path / "pipe"));
  EXPECT_EQ(get("read.svg"), get("drawing.svg"));
}

}  // namespace
}  // namespace robcogen::test::outputs_test
