// The help of every subcommand has examples that work, and the manual page contains all of the help.
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "run_tool.h"

namespace robcogen::test::help_test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The names that `robcogen --help` lists after `Subcommands:`.
std::vector<std::string> subcommands() {
  std::vector<std::string> names;
  bool is_list = false;
  for (const std::string& line : lines_of(run_tool("--help").output)) {
    if (line.empty()) is_list = false;
    if (is_list) names.push_back(line.substr(2, line.find(' ', 2) - 2));
    if (line == "Subcommands:") is_list = true;
  }
  return names;
}

// The commands after `Example:` or `Examples:` at the end of a help text.
std::vector<std::string> examples(const std::string& help) {
  std::vector<std::string> found;
  bool is_example = false;
  for (const std::string& line : lines_of(help)) {
    if (is_example && !line.empty()) found.push_back(line);
    if (line.starts_with("Example")) is_example = true;
  }
  return found;
}

constexpr const char* kArm = R"(Robot Arm {
  RobotBase base { children { upper via shoulder } }
  link upper { id = 1  inertia_params { mass = 2.0  CoM = (0.1, 0.0, 0.0)  Ix = 0.01  Iy = 0.04  Iz = 0.04  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0 }
    children { lower via elbow } }
  link lower { id = 2  inertia_params { mass = 1.0  CoM = (0.1, 0.0, 0.0)  Ix = 0.01  Iy = 0.02  Iz = 0.02  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0 }
    children { } }
  r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (PI / 2.0, 0.0, 0.0) } }
  r_joint elbow { ref_frame { translation = (0.3, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
}
)";

TEST(Help, ExamplesOfEverySubcommandWork) {
  const Scratch scratch("examples");
  write_text(scratch.path / "arm.kindsl", kArm);
  write_text(
      scratch.path / "arm.dtdsl", "Robot Arm\nFrames { fr_base, fr_lower }\nTransforms { fr_base <- fr_lower }\n");
  ASSERT_EQ(
      run_tool("convert " + quoted(scratch.path / "arm.kindsl") + " " + quoted(scratch.path / "arm.urdf")).status, 0);
  write_text(scratch.path / "robcogen", "#!/bin/sh\nexec '" ROBCOGEN_TOOL "' \"$@\"\n");
  permissions(scratch.path / "robcogen", std::filesystem::perms::owner_all);
  std::vector<std::string> helps = {"--help"};
  for (const std::string& name : subcommands()) helps.push_back(name + " --help");
  ASSERT_GT(helps.size(), 10U);
  for (const std::string& help : helps) {
    const std::vector<std::string> commands = examples(run_tool(help).output);
    EXPECT_FALSE(commands.empty()) << help;
    for (const std::string& command : commands) {
      EXPECT_NE(command.find("robcogen"), std::string::npos) << command;
      if (command.find("# fish") != std::string::npos) continue;
      write_text(
          scratch.path / "example.sh",
          "set -e -o pipefail\ncd " + quoted(scratch.path) + "\nPATH=\"$PWD:$PATH\"\n" + command + "\n");
      const std::string log = (scratch.path / "log").string();
      const int status =
          std::system(("bash " + quoted(scratch.path / "example.sh") + " < /dev/null > " + log + " 2>&1").c_str());
      // A language server exits with 1 if its input ends without a shutdown.
      const int expected = command.find("language-server") == std::string::npos ? 0 : 1;
      EXPECT_EQ(WEXITSTATUS(status), expected) << command << "\n" << read_text(log);
    }
  }
  for (const char* made :
       {"generated/arm/arm.h", "generated/c/left_arm_c/left_arm_c.h", "arm_of_urdf.kindsl", "arm.svg", "arm.html",
        "robcogen.1"})
    EXPECT_GT(read_text(scratch.path / made).size(), 100U) << made;
}

TEST(Help, SaysWhichTransformsCanBeEvaluated) {
  const std::string help = run_tool("eval --help").output;
  EXPECT_NE(help.find("of a robot, a transform or Jacobian between any two frames"), std::string::npos) << help;
  EXPECT_NE(help.find("--desired selects other transforms of motions"), std::string::npos) << help;
}

TEST(Manual, HasEverySubcommandAndOption) {
  const std::string page = run_tool("manual").output;
  EXPECT_TRUE(page.starts_with(".TH ROBCOGEN 1 ")) << page.substr(0, 80);
  std::string plain;
  for (const char c : page)
    if (c != '\\') plain += c;
  for (const std::string& name : subcommands()) {
    EXPECT_NE(plain.find("\n.SS " + name + "\n"), std::string::npos) << name;
    std::istringstream words(run_tool(name + " --help").output);
    for (std::string word; words >> word;) {
      const std::size_t start = word.find("--");
      if (start == std::string::npos || (start > 0 && word[start - 1] != ',')) continue;
      const std::string option =
          word.substr(start, word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", start) - start);
      EXPECT_NE(plain.find("fB" + option + "fR"), std::string::npos) << name << " " << option;
    }
  }
}

TEST(Manual, FormatsWithoutAWarning) {
  if (std::system("groff --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no groff";
  const Scratch scratch("manual");
  write_text(scratch.path / "robcogen.1", run_tool("manual").output);
  const std::string log = (scratch.path / "log").string();
  EXPECT_EQ(
      std::system(("groff -man -Tascii -ww -z " + quoted(scratch.path / "robcogen.1") + " > " + log + " 2>&1").c_str()),
      0);
  EXPECT_EQ(read_text(log), "");
}

}  // namespace
}  // namespace robcogen::test::help_test
