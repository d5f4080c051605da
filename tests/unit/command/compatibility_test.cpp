// The option --compatibility: headers of the first RobCoGen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "run_tool.h"

namespace robcogen::test::compatibility_test {
namespace {

namespace fs = std::filesystem;

std::string generate_with(const fs::path& model, const fs::path& output, const std::string& options) {
  return "generate " + quoted(model) + " -o " + quoted(output) + " --effort 0 " + options;
}

// Of a robot with transforms between all frames, one line for each.
TEST(Compatibility, HeadersAreShort) {
  const Scratch scratch("compatibility");
  const Outcome run = run_tool(generate_with(
      robot("quadruped"), scratch.path,
      "--compatibility robcogen --namespace iit::HyQ --algorithms energy --frames '*'"));
  ASSERT_EQ(run.status, 0) << run.errors;
  std::ptrdiff_t lines = 0;
  for (const auto& entry : fs::recursive_directory_iterator(scratch.path / "iit" / "robots" / "quadruped"))
    if (entry.is_regular_file()) {
      const std::string text = read_text(entry.path());
      lines += std::count(text.begin(), text.end(), '\n');
      EXPECT_EQ(text.find('@'), std::string::npos) << entry.path();
    }
  EXPECT_LE(lines, 1000);
  const std::string text = read_text(scratch.path / "iit" / "robots" / "quadruped" / "declarations.h");
  EXPECT_NE(text.find("namespace iit::HyQ {"), std::string::npos);
  EXPECT_NE(text.find("LF_HIPASSEMBLY,"), std::string::npos);
  const std::string list = read_text(scratch.path / "iit" / "robots" / "quadruped" / "detail" / "transforms.inc");
  EXPECT_NE(list.find("\nROBCOGEN_TRANSFORM(fr_trunk_X_fr_LF_hipassembly, ChildToParent<0>)\n"), std::string::npos);
  EXPECT_NE(list.find("\nROBCOGEN_TRANSFORM(fr_LF_hipassembly_X_fr_trunk, ParentToChild<0>)\n"), std::string::npos);
}

TEST(Compatibility, OtherRobotsAreRefused) {
  const Scratch scratch("compatibility-refused");
  const fs::path model = scratch.path / "pair.kindsl";
  const auto refused = [&](const std::string& first, const std::string& joints) {
    std::string text =
        "Robot Pair {\nRobotBase base { children { slow via " + first +
        " } }\nlink slow { id = 1\n  inertia_params { mass = 1 CoM = "
        "(0,0,0) Ix = 1 Iy = 1 Iz = 1 Ixy = 0 Ixz = 0 Iyz = 0 }\n  children { fast via B } }\nlink fast { id = 2\n  "
        "inertia_params { mass = 1 CoM = (0,0,0) Ix = 1 Iy = 1 Iz = 1 Ixy = 0 Ixz = 0 Iyz = 0 }\n  children {} }\n" +
        joints + "}\n";
    write_text(model, text);
    const Outcome run = run_tool(generate_with(model, scratch.path / "out", "--compatibility robcogen"));
    EXPECT_EQ(run.status, 1);
    EXPECT_FALSE(fs::exists(scratch.path / "out"));
    return run.errors;
  };
  const std::string frame = "ref_frame { translation = (0,0,0) rotation = (0,0,0) }";
  const std::string spherical = refused("A", "r_joint A { " + frame + " }\ns_joint B { " + frame + " }\n");
  EXPECT_NE(spherical.find("error: --compatibility: joint 'B' is spherical [compatibility-joint]"), std::string::npos)
      << spherical;
  EXPECT_NE(spherical.find("pair.kindsl:10:"), std::string::npos) << spherical;
  const std::string names = refused("FAST", "r_joint FAST { " + frame + " }\nr_joint B { " + frame + " }\n");
  EXPECT_NE(
      names.find("error: --compatibility: link 'fast' and joint 'FAST' would both be the enumerator 'FAST' "
                 "[compatibility-names]"),
      std::string::npos)
      << names;
}

TEST(Compatibility, OptionsAreChecked) {
  const Scratch scratch("compatibility-options");
  const std::pair<const char*, const char*> cases[] = {
      {"--compatibility robcogen --language c", "--compatibility is for --language cpp, not for c"},
      {"--include-path iit/robots/hyl", "--include-path needs --compatibility"},
      {"--compatibility robcogen --include-path ../hyl",
       "--include-path '../hyl' is not a folder as #include lines name it, such as iit/robots/hyq"},
      {"--compatibility robcogen --include-path /hyl", "--include-path '/hyl' is not a folder"},
      {"--compatibility robcogen --include-path hyl/", "--include-path 'hyl/' is not a folder"}};
  for (const auto& [options, message] : cases) {
    const Outcome run = run_tool(generate_with(robot("hyl"), scratch.path / "out", options));
    EXPECT_EQ(run.status, 2) << options;
    EXPECT_NE(run.errors.find(message), std::string::npos) << run.errors;
    EXPECT_FALSE(fs::exists(scratch.path / "out"));
  }
  const Outcome run = run_tool(generate_with(
      fs::path(ROBCOGEN_ROBOTS_DIR) / "euler" / "euler.motdsl", scratch.path / "out", "--compatibility robcogen"));
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.errors.find("--compatibility applies to robots only"), std::string::npos) << run.errors;
}

}  // namespace
}  // namespace robcogen::test::compatibility_test
