// Wrong command lines: their messages, and a check that none causes an internal fault.
#include <gtest/gtest.h>

#include <random>

#include "run_tool.h"

namespace robcogen::test::usage_test {
namespace {

TEST(Usage, GuessesWhatWasMeant) {
  const std::string model = quoted(robot("hyl"));
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"chek " + model, "'check'"},
      {"genrate " + model, "'generate'"},
      {"check --strct " + model, "'--strict'"},
      {"ops --algoritms energy " + model, "'--algorithms'"},
      {"ops " + model + " --algorithms invers_dynamics", "'inverse_dynamics'"},
      {"ops " + model + " --passes canonicl", "'canonical'"},
      {"ops " + model + " --passes=frames,sinc", "'sink'"},
      {"generate " + model + " --name h -o o --language mathlab", "'matlab'"},
      {"generate " + model + " --name h -o o --language cpp,mathlab", "'matlab'"},
      {"generate " + model + " --name h -o o --primitives lefd", "'left'"},
      {"check " + model + " --error-format mscv", "'msvc'"},
      {"print " + model + " --program invers_dynamics", "'inverse_dynamics'"},
      {"eval " + model + " inverse_dynamic", "'inverse_dynamics'"}};
  for (const auto& [arguments, guess] : cases) {
    const Outcome run = run_tool(arguments, "{}");
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_EQ(run.output, "") << arguments;
    EXPECT_NE(run.errors.find("hint: did you mean " + guess + "?"), std::string::npos) << run.errors;
  }
}

TEST(Usage, NoOptionIsAcceptedAndIgnored) {
  const Outcome run = run_tool("generate " + quoted(robot("hyl")) + " --name h -o /nowhere/o -J .");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.errors.find("'-J' is not an option of robcogen generate"), std::string::npos) << run.errors;
}

TEST(Usage, ValuesOfOptionsAreExplained) {
  const std::string model = " " + quoted(robot("hyl"));
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"ops --effort 1.5" + model, "--effort: '1.5' is not a whole number"},
      {"ops --effort=-1" + model, "--effort: Value -1 not in range 0 to 1000"}};
  for (const auto& [arguments, message] : cases) {
    const Outcome run = run_tool(arguments);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_EQ(run.errors.find("robcogen: error: " + message + "\n"), 0U) << run.errors;
  }
}

TEST(Usage, FoldersOfImportsThatDoNotExistAreMentioned) {
  const Scratch scratch("no-folder");
  const std::string model = quoted(robot("hyl"));
  for (const std::string& command :
       {"check " + model, "print --expand " + model, "ops " + model + " --algorithms energy",
        "convert " + model + " " + quoted(scratch.path / "hyl.urdf")}) {
    const Outcome run = run_tool(command + " -I no-such-folder -I " + quoted(scratch.path));
    EXPECT_EQ(run.status, 0) << command;
    EXPECT_EQ(run.errors.find("robcogen: warning: -I: folder 'no-such-folder' does not exist [no-import-folder]\n"), 0U)
        << run.errors;
    EXPECT_EQ(run.errors.find(scratch.path.string() + "'"), std::string::npos) << run.errors;
  }
}

TEST(Usage, ListsMayHaveCommas) {
  const Scratch scratch("commas");
  const Outcome run = run_tool(
      "generate " + quoted(robot("hyl")) + " -o " + quoted(scratch.path / "out") +
      " --effort 0 --algorithms energy --processors baseline,avx2 --language cpp,matlab");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_TRUE(std::filesystem::exists(scratch.path / "out" / "hyl" / "kernels_avx2_1.cpp"));
  EXPECT_TRUE(std::filesystem::exists(scratch.path / "out" / "matlab"));
}

// None of the requested languages supports the option.
TEST(Usage, OptionsOfOtherLanguagesAreRefused) {
  const Scratch scratch("other-languages");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--batch --language matlab", "--batch is for --language cpp, not for matlab"},
      {"--single-precision --language c maxima", "--single-precision is for --language cpp, not for c, maxima"},
      {"--double-only --language maxima", "--double-only is for --language cpp, not for maxima"},
      {"--processors baseline avx2 --language c", "--processors is for --language cpp, not for c"},
      {"--vamp tool --language c", "--vamp is for --language cpp, not for c"},
      {"--primitives left", "--primitives is for --language matlab or maxima or javascript, not for cpp"}};
  for (const auto& [options, message] : cases) {
    const Outcome run =
        run_tool("generate " + quoted(robot("hyl")) + " -o " + quoted(scratch.path / "out") + " " + options);
    EXPECT_EQ(run.status, 2) << options;
    EXPECT_EQ(run.errors, "robcogen: error: " + message + "\n");
    EXPECT_FALSE(std::filesystem::exists(scratch.path / "out"));
  }
  const Outcome both = run_tool(
      "generate " + quoted(robot("hyl")) + " -o " + quoted(scratch.path / "out") +
      " --effort 0 --algorithms energy --batch --processors baseline --primitives left --language cpp matlab");
  EXPECT_EQ(both.status, 0) << both.errors;
}

TEST(Usage, EverySingleStepAndNone) {
  for (const char* steps :
       {"none", "base-parameters", "choose-fd", "frames", "turn-inertia", "reverse-mode", "canonical", "reassociate",
        "sink", "lanes", "lanes,frames", "sink,lanes", "sink,sink"})
    for (const char* name : {"hyl_parametric", "quadruped"}) {
      const std::string command = "ops --lanes --algorithms inverse_dynamics,jacobians --passes ";
      const Outcome run = run_tool(command + steps + " " + quoted(robot(name)));
      EXPECT_EQ(run.status, 0) << name << " " << steps << "\n" << run.errors;
      EXPECT_NE(run.output, "") << name << " " << steps;
    }
  const Outcome both = run_tool("ops --passes none,sink " + quoted(robot("hyl")));
  EXPECT_EQ(both.status, 2);
  EXPECT_NE(both.errors.find("--passes: 'none' excludes other steps"), std::string::npos) << both.errors;
}

// Random combinations of command-line words, applied to small documents.
TEST(Usage, NothingThatCanBeTypedIsAnInternalFault) {
  const Scratch scratch("fuzz");
  const auto file = [&](const std::string& name, const std::string& text) {
    write_text(scratch.path / name, text);
    return quoted(scratch.path / name);
  };
  const std::string motions = file("m.motdsl", "Model m Convention = local a -> b : rotx(q)");
  const std::vector<std::string> subcommands = {"check",    "print", "ops",  "eval", "convert",
                                                "generate", "draw",  "view", "''",   "--help"};
  const std::vector<std::string> words = {
      quoted(robot("hyl")),
      motions,
      file("empty.kindsl", ""),
      file("bytes.kindsl", "\xff\xfe Robot \x80"),
      file("new\nline.kindsl", "Robot"),
      file("x.urdf", "<robot name='r'><link name='a'/></robot>"),
      file("list.dtdsl", "Robot HyL Transforms { fr_base <- fr_foot }"),
      quoted(scratch.path / "out.urdf"),
      quoted(scratch.path / "out.ctdsl"),
      quoted(scratch.path / "none"),
      quoted(scratch.path),
      "''",
      "-",
      "--",
      "'\n'",
      "$'\\xff\\xfe'",
      "999999999999999999999",
      "-1",
      "nan",
      "1e999",
      std::string(5000, 'x'),
      "inverse_dynamics",
      "jacobians.fr_base_J_fr_foot",
      "jacobians.",
      "transforms.homogeneous._X_",
      "update_both",
      "--strict",
      "--quiet",
      "--strict=2",
      "--desired",
      "--passes",
      "--passes=none",
      "--passes=frames",
      "--passes=,",
      "--passes=lanes,sink",
      "--effort",
      "--effort=0",
      "--effort=3",
      "--effort=''",
      "--floating-base",
      "--snap-angles",
      "--free-mimic-joints",
      "--passive-forces",
      "--friction-velocity",
      "--friction-velocity=0.01",
      "--friction-velocity=0",
      "--friction-velocity=inf",
      "--allow-implausible",
      "--robot",
      "--robot=arm",
      "--error-format",
      "--error-format=msvc",
      "--algorithms",
      "--algorithms=energy,jacobians",
      "--algorithms=",
      "--lanes",
      "--json",
      "--json=false",
      "--program",
      "--program=gravity_forces",
      "--position=left",
      "--name",
      "--name=hyl",
      "--name=$'\\xff'",
      "--namespace=a::b",
      "--namespace=::",
      "--batch",
      "--double-only",
      "--single-precision",
      "--language=matlab",
      "--language=maxima",
      "--language=cpp",
      "--primitives=left",
      "-o",
      "-o" + quoted(scratch.path / "gen"),
      "--depfile=" + quoted(scratch.path / "d"),
      "--depfile-target=t",
      "--stamp=" + quoted(scratch.path / "s"),
      "--list-outputs",
      "--version"};
  std::mt19937 random(1);
  const auto pick = [&](const std::vector<std::string>& list) { return list[random() % list.size()]; };
  const std::string script = quoted(scratch.path / "script");
  for (int i = 0; i < (ROBCOGEN_TEST_EVERYTHING ? 250 : 30); ++i) {
    std::string line = "'" ROBCOGEN_TOOL "' " + pick(subcommands);
    for (auto left = 1 + random() % 5; left > 0; --left) line += " " + pick(words);
    write_text(scratch.path / "script", line + " <<< '{\"q\": [0, 0, 0]}'\n");
    const int status = std::system(("bash " + script + " > /dev/null 2> " + quoted(scratch.path / "errors")).c_str());
    const std::string errors = read_text(scratch.path / "errors");
    ASSERT_TRUE(WIFEXITED(status)) << line << errors;
    EXPECT_LT(WEXITSTATUS(status), 3) << line << "\n" << errors;
    EXPECT_EQ(WEXITSTATUS(status) != 0, errors.find("error") != std::string::npos) << line << "\n" << errors;
  }
}

}  // namespace
}  // namespace robcogen::test::usage_test
