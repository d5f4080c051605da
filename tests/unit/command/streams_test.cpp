// Standard streams that are full, closed, endless or not files.
#include <gtest/gtest.h>

#include "run_tool.h"

namespace robcogen::test::streams_test {
namespace {

namespace fs = std::filesystem;

// Runs a shell script in which "$tool" is the generator.
Outcome run_script(const std::string& script) {
  const Scratch scratch("script");
  write_text(scratch.path / "script", "tool='" ROBCOGEN_TOOL "'\n" + script + "\n");
  const std::string command = "bash " + quoted(scratch.path / "script") + " > " + quoted(scratch.path / "output") +
                              " 2> " + quoted(scratch.path / "errors");
  const int status = std::system(command.c_str());
  return {
      WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(scratch.path / "output"),
      read_text(scratch.path / "errors")};
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

class Streams : public testing::Test {
 protected:
  // Command lines, and whether they write to standard output.
  std::vector<std::pair<std::string, bool>> commands() const {
    const std::string model = quoted(robot("hyl"));
    return {
        {"check " + model, false},
        {"convert " + model + " " + quoted(scratch_.path / "hyl.urdf"), false},
        {"generate " + model + " --name hyl -o " + quoted(scratch_.path / "out"), false},
        {"print " + model, true},
        {"print --program gravity_forces --effort 0 " + model, true},
        {"ops --effort 0 --algorithms energy " + model, true},
        {"ops --effort 0 --algorithms energy --json " + model, true},
        {"eval " + model + " potential_energy", true},
        {"generate --list-outputs --name hyl", true},
        {"--help", true},
        {"eval --help", true},
        {"--version", true}};
  }
  const std::string state_ = " <<< '{\"q\": [0, 0, 0]}'";
  Scratch scratch_{"streams"};
};

void expect_lost_output(const Outcome& run, const std::string& command) {
  EXPECT_EQ(run.status, 2) << command;
  EXPECT_EQ(count_of(run.errors, "error:"), 1U) << command << "\n" << run.errors;
  EXPECT_NE(run.errors.find("robcogen: error: cannot write standard output: "), std::string::npos) << run.errors;
  EXPECT_NE(run.errors.find("[output-lost]"), std::string::npos) << run.errors;
}

TEST_F(Streams, FullOutput) {
  for (const auto& [command, writes] : commands())
    expect_lost_output(run_script("\"$tool\" " + command + state_ + " > /dev/full"), command);
}

TEST_F(Streams, ClosedOutput) {
  for (const auto& [command, writes] : commands())
    expect_lost_output(run_script("\"$tool\" " + command + state_ + " >&-"), command);
}

// The reader is gone before the first byte is written: the script waits for the process at the other end of the pipe to
// exit.
TEST_F(Streams, OutputWithoutReader) {
  for (const auto& [command, writes] : commands()) {
    if (!writes) continue;
    expect_lost_output(run_script("exec 3> >(exec true); wait $!; \"$tool\" " + command + state_ + " >&3"), command);
  }
}

TEST_F(Streams, LostMessagesAreAFault) {
  EXPECT_EQ(run_script("\"$tool\" check /nowhere.kindsl 2> /dev/full").status, 2);
  write_text(scratch_.path / "bad.kindsl", "Robot");
  for (const char* lost : {"/dev/full", "&-"})
    EXPECT_EQ(run_script("\"$tool\" check " + quoted(scratch_.path / "bad.kindsl") + " 2>" + lost).status, 2) << lost;
  // There was no message to print.
  EXPECT_EQ(run_script("\"$tool\" check " + quoted(robot("hyl")) + " 2>&-").status, 0);
}

// A file that is opened later must not take the place of standard output.
TEST_F(Streams, ClosedStreamsAreNotTakenByFiles) {
  const fs::path out = scratch_.path / "out";
  for (const char* closed : {"<&-", ">&-", "2>&-", "<&- >&- 2>&-"}) {
    fs::remove_all(out);
    run_script("\"$tool\" generate " + quoted(robot("hyl")) + " --name hyl -o " + quoted(out) + " " + closed);
    EXPECT_EQ(read_text(out / "hyl" / "hyl.h").rfind("// hyl/hyl.h", 0), 0U) << closed;
  }
}

TEST_F(Streams, UnreadableInput) {
  const std::string eval = "\"$tool\" eval " + quoted(robot("hyl")) + " potential_energy";
  for (const std::string& command : {std::string("\"$tool\" check -"), eval})
    for (const char* input : {" <&-", " < /"}) {
      const Outcome run = run_script(command + input);
      EXPECT_EQ(run.status, 2) << command << input;
      EXPECT_EQ(count_of(run.errors, "error:"), 1U) << run.errors;
      EXPECT_NE(run.errors.find("cannot read"), std::string::npos) << run.errors;
    }
  const Outcome folder = run_script("\"$tool\" check /");
  EXPECT_EQ(folder.status, 2);
  EXPECT_NE(folder.errors.find("a folder, not a file"), std::string::npos) << folder.errors;
}

TEST_F(Streams, InputWithoutEnd) {
  const std::string eval = "eval " + quoted(robot("hyl")) + " potential_energy";
  for (const std::string& script : {
#if ROBCOGEN_TEST_EVERYTHING
         std::string("\"$tool\" check /dev/zero"), std::string("\"$tool\" check - < /dev/zero"),
             std::string("yes | \"$tool\" check /dev/stdin"),
#endif
             std::string("yes | \"$tool\" check -")
       }) {
    const Outcome run = run_script(script);
    EXPECT_EQ(run.status, 2) << script;
    EXPECT_NE(run.errors.find("more than 64 MiB"), std::string::npos) << run.errors;
  }
  EXPECT_EQ(run_script("\"$tool\" " + eval + " < /dev/zero").status, 1);
  const Outcome blank = run_script("yes '' | \"$tool\" " + eval);
  EXPECT_EQ(blank.status, 1);
  EXPECT_NE(blank.errors.find("more than 16 MiB of white space [input-too-long]"), std::string::npos) << blank.errors;
  const Outcome state = run_script("{ echo '{\"q\": ['; yes '0,'; } | \"$tool\" " + eval);
  EXPECT_EQ(state.status, 1);
  EXPECT_NE(state.errors.find("an object of more than 16 MiB [input-too-long]"), std::string::npos) << state.errors;
}

TEST_F(Streams, BinaryFilesAreOneError) {
  for (const char* name : {"n.kindsl", "n.dtdsl", "n.motdsl", "n.ctdsl"}) {
    write_text(scratch_.path / name, "Robot R {\n" + std::string(100000, '\0'));
    const Outcome run = run_tool("check " + quoted(scratch_.path / name));
    EXPECT_EQ(run.status, 1) << name;
    EXPECT_NE(run.errors.find(":2:1: error: not a text file: byte 11 is zero [not-text]\n"), std::string::npos)
        << run.errors;
    EXPECT_EQ(count_of(run.errors, "error:"), 1U) << run.errors;
  }
}

}  // namespace
}  // namespace robcogen::test::streams_test
