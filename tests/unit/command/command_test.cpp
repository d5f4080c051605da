// Exit statuses, written files, and a check that the output depends only on the input.
#include <gtest/gtest.h>

#include <map>

#include "run_tool.h"

namespace robcogen::test::command_test {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
  return files;
}

TEST(Command, SaysItsVersionAndHelp) {
  const Outcome version = run_tool("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.output.rfind("robcogen ", 0), 0U) << version.output;
  const Outcome help = run_tool("--help");
  EXPECT_EQ(help.status, 0);
  for (const char* word : {"generate", "check", "print", "ops", "eval", "convert"})
    EXPECT_NE(help.output.find(word), std::string::npos) << word;
}

TEST(Command, UsageFaultsExitWithTwo) {
  for (const char* arguments :
       {"", "no-such-command", "check", "generate --name x", "ops no-such-file.kindsl", "generate a b c",
        "print --error-format pretty x.kindsl", "generate m.kindsl -o d --name 1x", "generate --list-outputs",
        "generate m.kindsl -o d --name x --namespace 'a:b'", "generate m.kindsl -o d --name x --algorithms nonsense"}) {
    const Outcome run = run_tool(arguments);
    EXPECT_EQ(run.status, 2) << arguments << "\n" << run.errors;
    EXPECT_NE(run.errors.find("error"), std::string::npos) << arguments;
    EXPECT_EQ(run.output, "") << arguments;
  }
}

TEST(Command, CodeIsCalledAfterTheModel) {
  const Scratch scratch("called");
  const std::string options = " --algorithms joint_space_inertia -o " + quoted(scratch.path / "out");
  const Outcome run = run_tool("generate " + quoted(robot("hyl")) + options);
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_TRUE(fs::exists(scratch.path / "out" / "hyl" / "hyl.h"));
  fs::copy_file(robot("hyl"), scratch.path / "hyl-2.kindsl");
  const Outcome refused = run_tool("generate " + quoted(scratch.path / "hyl-2.kindsl") + options);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("'hyl-2' is not a valid identifier"), std::string::npos) << refused.errors;
}

TEST(Command, WrongInputExitsWithOneAndWritesNothing) {
  const Scratch scratch("wrong");
  const fs::path model = scratch.path / "bad.kindsl";
  write_text(model, "Robot R { RobotBase b { children { l via j } } }");
  const fs::path out = scratch.path / "out";
  const Outcome run = run_tool(
      "generate " + quoted(model) + " -o " + quoted(out) + " --name r --depfile " + quoted(scratch.path / "r.d") +
      " --stamp " + quoted(scratch.path / "r.stamp"));
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("bad.kindsl:1:36: error:"), std::string::npos) << run.errors;
  EXPECT_FALSE(fs::exists(out));
  EXPECT_FALSE(fs::exists(scratch.path / "r.d"));
  EXPECT_FALSE(fs::exists(scratch.path / "r.stamp"));
}

// A robot with a singular inertia matrix gets a warning, or an error if a function that needs the inverse is requested.
TEST(Command, LeavesOutWhatDividesByASingularInertiaMatrix) {
  const Scratch scratch("singular");
  const fs::path model = fs::path(ROBCOGEN_ROBOTS_DIR).parent_path() / "tests/inertia/stylus.kindsl";
  const Outcome ops = run_tool("ops " + quoted(model));
  EXPECT_EQ(ops.status, 0);
  EXPECT_NE(ops.errors.find("warning: joint 'twist' has no effective inertia"), std::string::npos) << ops.errors;
  EXPECT_NE(ops.errors.find("[singular-inertia]"), std::string::npos) << ops.errors;
  EXPECT_NE(ops.output.find("\ninverse_dynamics "), std::string::npos) << ops.output;
  EXPECT_EQ(ops.output.find("\nforward_dynamics "), std::string::npos) << ops.output;
  const auto generate = [&](const std::string& groups) {
    return run_tool("generate " + quoted(model) + " --name stylus -o " + quoted(scratch.path / "out") + groups);
  };
  const Outcome asked = generate(" --algorithms inverse_dynamics forward_dynamics");
  EXPECT_EQ(asked.status, 1);
  EXPECT_NE(asked.errors.find("error: joint 'twist' has no effective inertia"), std::string::npos) << asked.errors;
  EXPECT_FALSE(fs::exists(scratch.path / "out"));
  const Outcome evaluated = run_tool("eval " + quoted(model) + " forward_dynamics", "{}");
  EXPECT_EQ(evaluated.status, 1);
  EXPECT_NE(evaluated.errors.find("[singular-inertia]"), std::string::npos) << evaluated.errors;
  EXPECT_EQ(generate(" --algorithms all").status, 0);
  EXPECT_EQ(generate("").status, 0);
  EXPECT_TRUE(fs::exists(scratch.path / "out/stylus/kernel/forward_dynamics.h"));
}

TEST(Command, AnErrorLeavesEarlierOutputAlone) {
  const Scratch scratch("again");
  const fs::path model = scratch.path / "r.kindsl", out = scratch.path / "out";
  fs::copy_file(robot("hyl"), model);
  const std::string generate = "generate " + quoted(model) + " -o " + quoted(out) + " --name r";
  ASSERT_EQ(run_tool(generate).status, 0);
  const auto before = files_below(out);
  ASSERT_FALSE(before.empty());
  write_text(model, read_text(model) + "}");
  EXPECT_EQ(run_tool(generate).status, 1);
  EXPECT_EQ(files_below(out), before);
}

TEST(Command, UnwritableOutputExitsWithTwo) {
  const Scratch scratch("unwritable");
  write_text(scratch.path / "file", "");
  const Outcome run =
      run_tool("generate " + quoted(robot("hyl")) + " -o " + quoted(scratch.path / "file" / "out") + " --name hyl");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.errors.find("error"), std::string::npos);
}

TEST(Command, WritesWhatItListsAndNothingElse) {
  const Scratch scratch("list");
  for (const std::string algorithms : {"", " --algorithms jacobians inverse_dynamics", " --contacts fr_foot"}) {
    const fs::path out = scratch.path / ("out" + std::to_string(algorithms.size()));
    const Outcome list = run_tool("generate --list-outputs --name hyl" + algorithms);
    ASSERT_EQ(list.status, 0) << list.errors;
    ASSERT_EQ(
        run_tool("generate " + quoted(robot("hyl")) + " -o " + quoted(out) + " --name hyl" + algorithms).status, 0);
    std::string written;
    for (const auto& [name, text] : files_below(out)) {
      EXPECT_NE(list.output.find(name + "\n"), std::string::npos) << name;
      written += name;
    }
    EXPECT_EQ(
        static_cast<std::size_t>(std::count(list.output.begin(), list.output.end(), '\n')), files_below(out).size());
  }
}

// A locale with a decimal comma, the folder and the time must not affect the output.
TEST(Command, SameInputSameBytes) {
  const Scratch scratch("same");
  const fs::path elsewhere = scratch.path / "else where";
  fs::create_directories(elsewhere);
  fs::copy_file(robot("quadruped"), elsewhere / "quadruped.kindsl");
  ASSERT_EQ(
      run_tool("generate " + quoted(robot("quadruped")) + " -o " + quoted(scratch.path / "a") + " --name q").status, 0);
  ASSERT_EQ(
      run_tool(
          "generate " + quoted(elsewhere / "quadruped.kindsl") + " -o " + quoted(scratch.path / "b") + " --name q", "",
          "LC_ALL=de_DE.UTF-8")
          .status,
      0);
  EXPECT_EQ(files_below(scratch.path / "a"), files_below(scratch.path / "b"));
}

TEST(Command, ACommentChangesNothing) {
  const Scratch scratch("comment");
  const fs::path model = scratch.path / "r.kindsl", out = scratch.path / "out";
  fs::copy_file(robot("hyl"), model);
  const std::string generate = "generate " + quoted(model) + " -o " + quoted(out) + " --name r";
  ASSERT_EQ(run_tool(generate).status, 0);
  const auto before = files_below(out);
  const auto time = fs::last_write_time(out / "r" / "model.h");
  write_text(model, "// a remark\n\n" + read_text(model));
  ASSERT_EQ(run_tool(generate).status, 0);
  EXPECT_EQ(files_below(out), before);
  EXPECT_EQ(fs::last_write_time(out / "r" / "model.h"), time);
}

TEST(Command, PrintsCanonicalDocumentsThatPrintTheSame) {
  const Scratch scratch("print");
  for (const char* name : {"hyl", "humanoid"}) {
    const Outcome first = run_tool("print " + quoted(robot(name)));
    ASSERT_EQ(first.status, 0);
    const fs::path copy = scratch.path / "copy.kindsl";
    write_text(copy, first.output);
    EXPECT_EQ(run_tool("print " + quoted(copy)).output, first.output);
  }
}

TEST(Command, StrictRefusesWhatIsLenientOtherwise) {
  const Scratch scratch("strict");
  const fs::path list = scratch.path / "list.dtdsl";
  write_text(list, "Robot HyL Frames { fr_base } Transforms { fr_base <- fr_foot fr_base <- fr_nothing }");
  const std::string files = quoted(robot("hyl")) + " " + quoted(list);
  const Outcome lenient = run_tool("check " + files), strict = run_tool("check --strict " + files);
  EXPECT_EQ(lenient.status, 0);
  EXPECT_NE(lenient.errors.find("warning"), std::string::npos);
  EXPECT_EQ(strict.status, 1);
}

TEST(Command, ChecksOurRobotsWithoutAWord) {
  for (const auto& entry : fs::directory_iterator(ROBCOGEN_ROBOTS_DIR)) {
    const std::string name = entry.path().filename().string();
    if (!fs::exists(robot(name))) continue;
    const Outcome run = run_tool(
        "check --strict " + quoted(robot(name)) + " " + quoted(fs::path(robot(name)).replace_extension(".dtdsl")));
    EXPECT_EQ(run.status, 0) << name;
    const bool has_parameters = name == "hyl_parametric";  // parameters are listed
    EXPECT_EQ(run.errors.find("[parameters]") != std::string::npos, has_parameters) << name << "\n" << run.errors;
    EXPECT_EQ(run.errors.find("warning"), std::string::npos) << name << "\n" << run.errors;
  }
}

TEST(Command, RobotsBeyondAllMeasureAreCheckedButNotTraced) {
  const Scratch scratch("huge");
  const fs::path model = scratch.path / "chain.kindsl";
  std::string text = "Robot Chain {\nRobotBase l0 { children { l1 via j1 } }\n";
  const int joints = ROBCOGEN_TEST_EVERYTHING ? 20000 : 4000;
  for (int i = 1; i <= joints; ++i) {
    const std::string n = std::to_string(i), next = std::to_string(i + 1);
    text += "link l" + n + " { id = " + n +
            " inertia_params { mass = 1 CoM = (0, 0, 0) Ix = 1 Iy = 1 Iz = 1 Ixy = 0 Ixz = 0 Iyz = 0 } children { " +
            (i < joints ? "l" + next + " via j" + next : "") + " } }\nr_joint j" + n +
            " { ref_frame { translation = (0.1, 0, 0) rotation = (0, 0, 0) } }\n";
  }
  write_text(model, text + "}\n");
  const Outcome check = run_tool("check " + quoted(model));
  EXPECT_EQ(check.status, 0);
  EXPECT_NE(
      check.errors.find(
          "warning: robot 'Chain' has " + std::to_string(joints) + " joints; the limit is 1000 [too-many-joints]"),
      std::string::npos)
      << check.errors;
  const std::string file = quoted(model);
  for (const std::string& command :
       {"ops " + file, "eval " + file + " inverse_dynamics",
        "generate " + file + " --name c -o " + quoted(scratch.path / "o")}) {
    const Outcome run = run_tool(command, "{}");
    EXPECT_EQ(run.status, 1) << command;
    EXPECT_NE(run.errors.find("[too-many-joints]"), std::string::npos) << run.errors;
  }
}

TEST(Command, RobotsWithParametersAreEvaluatedAndGenerated) {
  const Scratch scratch("parametric");
  const fs::path model = scratch.path / "p.kindsl";
  write_text(model, R"(Robot P {
    RobotBase b { children { l via j } }
    link l { id = 1 inertia_params { mass = m CoM = (0.5 len, 0.0, 0.0)
      Ix = 0.0 Iy = 0.1 Iz = 0.1 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children {} }
    r_joint j { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (PI/2.0, 0.0, 0.0) } } })");
  const Outcome generate = run_tool("generate " + quoted(model) + " -o " + quoted(scratch.path / "o") + " --name p");
  EXPECT_EQ(generate.status, 0) << generate.errors;
  EXPECT_TRUE(fs::exists(scratch.path / "o" / "p" / "parameters.h"));
  const Outcome eval =
      run_tool("eval " + quoted(model) + " gravity_forces", R"({"q": [0], "parameters": {"m": 2, "len": 3}})");
  EXPECT_EQ(eval.status, 0) << eval.errors;
  // The rod lies along x and turns about -y of the base, so the moment is m g len / 2.
  EXPECT_EQ(eval.output, "{\"tau\": [29.43]}\n");
  EXPECT_EQ(run_tool("eval " + quoted(model) + " gravity_forces", "{}").status, 1);
}

}  // namespace
}  // namespace robcogen::test::command_test
