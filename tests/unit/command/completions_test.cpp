// Command-line completion scripts, run by the shells themselves.
#include <gtest/gtest.h>

#include "run_tool.h"

namespace robcogen::test::completions_test {
namespace {

// Returns what bash offers for a command line, one word per line.
std::string completed(const std::string& words, int current) {
  const Outcome script = run_tool("completions bash");
  EXPECT_EQ(script.status, 0);
  const Scratch scratch("completions");
  write_text(
      scratch.path / "use.sh", script.output + "COMP_WORDS=(" + words + ")\nCOMP_CWORD=" + std::to_string(current) +
                                   "\n_robcogen\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
  const std::string command = "bash -u " + (scratch.path / "use.sh").string() + " > " + (scratch.path / "out").string();
  EXPECT_EQ(std::system(command.c_str()), 0);
  return read_text(scratch.path / "out");
}

TEST(Completions, OfSubcommandsOptionsAndValues) {
  EXPECT_EQ(completed("robcogen ge", 1), "generate\n");
  EXPECT_EQ(completed("robcogen generate --depfile-", 2), "--depfile-target\n");
  EXPECT_EQ(completed("robcogen generate --language ma", 3), "matlab\nmaxima\n");
  EXPECT_EQ(completed("robcogen generate --algorithms inverse_dynamics_g", 3), "inverse_dynamics_gradient\n");
  EXPECT_EQ(completed("robcogen convert --position ''", 3), "left\nright\n");
  EXPECT_EQ(completed("robcogen completions z", 2), "\n");  // may be a file name, as far as the script knows
  EXPECT_EQ(completed("robcogen generate arm", 2), "\n");
  EXPECT_NE(completed("robcogen ''", 1).find("eval\n"), std::string::npos);
}

TEST(Completions, OfFishHaveEverySubcommand) {
  const Outcome script = run_tool("completions fish");
  for (const char* name : {"generate", "check", "print", "ops", "eval", "convert", "completions"})
    EXPECT_NE(script.output.find(std::string("__fish_use_subcommand -a ") + name + " -d '"), std::string::npos) << name;
  EXPECT_NE(
      script.output.find("complete -c robcogen -n '__fish_seen_subcommand_from convert' -l position"),
      std::string::npos);
}

TEST(Completions, OfZshAreThoseOfBash) {
  const std::string script = run_tool("completions zsh").output;
  EXPECT_NE(script.find(run_tool("completions bash").output), std::string::npos);
  EXPECT_TRUE(script.starts_with("#compdef robcogen\n"));
  EXPECT_EQ(run_tool("completions tcsh").status, 2);
}

}  // namespace
}  // namespace robcogen::test::completions_test
