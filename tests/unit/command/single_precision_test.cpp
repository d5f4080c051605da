// The option --single-precision: without it, libraries have nothing in single precision.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "patterns.h"
#include "run_tool.h"

namespace robcogen::test::single_precision_test {
namespace {

namespace fs = std::filesystem;

using Lines = std::map<std::string, std::string>;

// The first line that refers to single precision, comments excluded, of each file that has one.
Lines single_precision(const fs::path& folder) {
  Lines result;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::istringstream lines(read_text(entry.path()));
    for (std::string line; std::getline(lines, line);) {
      if (line.find("float") == std::string::npos && line.find("f32") == std::string::npos) continue;
      if (first_match(line.substr(0, line.find("//")), R"(\b(float|f32)\b)"))
        result.emplace(entry.path().lexically_relative(folder).string(), line);
    }
  }
  return result;
}

std::string generate(const std::string& model, const fs::path& folder, const std::string& options) {
  const Outcome run = run_tool("generate " + model + " -o " + quoted(folder) + " --effort 0 --name it" + options);
  EXPECT_EQ(run.status, 0) << run.errors;
  return run_tool("generate --list-outputs --name it" + options, "").output;
}

TEST(SinglePrecision, IsAbsentFromRobots) {
  const std::string options = " --batch --processors baseline avx2 avx512 --algorithms all";
  std::vector<std::string> names = {"hyl_parametric"};
  if (ROBCOGEN_TEST_EVERYTHING) names.insert(names.end(), {"hyl", "quadruped"});
  for (const std::string& name : names) {
    const Scratch scratch("single-precision-" + name);
    const std::string files = generate(quoted(robot(name)), scratch.path / "double", options);
    EXPECT_EQ(single_precision(scratch.path / "double"), Lines()) << name;
    EXPECT_EQ(generate(quoted(robot(name)), scratch.path / "both", options + " --single-precision"), files);
    EXPECT_GT(single_precision(scratch.path / "both").size(), 40u) << name;
  }
}

TEST(SinglePrecision, IsAbsentFromTransforms) {
  const Scratch scratch("single-precision-transforms");
  const std::string model = quoted(fs::path(ROBCOGEN_ROBOTS_DIR) / "euler" / "euler.motdsl");
  generate(model, scratch.path / "double", "");
  EXPECT_EQ(single_precision(scratch.path / "double"), Lines());
  generate(model, scratch.path / "both", " --single-precision");
  EXPECT_FALSE(single_precision(scratch.path / "both").empty());
}

// The header says which option adds what a user may miss.
TEST(SinglePrecision, IsOfferedInTheHeader) {
  const Scratch scratch("single-precision-hint");
  generate(quoted(robot("hyl")), scratch.path / "double", "");
  const std::string header = read_text(scratch.path / "double" / "it" / "it.h");
  EXPECT_NE(header.find("SINGLE_PRECISION"), std::string::npos) << header.substr(0, 1000);
  EXPECT_NE(header.find("FRAMES"), std::string::npos) << header.substr(0, 1000);
}

TEST(SinglePrecision, LeavesKernelsAsTheyAre) {
  const Scratch scratch("single-precision-kernels");
  generate(quoted(robot("hyl")), scratch.path / "double", "");
  generate(quoted(robot("hyl")), scratch.path / "both", " --single-precision");
  for (const char* group : {"inverse_dynamics", "forward_dynamics", "transforms"}) {
    const fs::path path = fs::path("it") / "kernel" / (std::string(group) + ".h");
    EXPECT_EQ(read_text(scratch.path / "double" / path), read_text(scratch.path / "both" / path));
    EXPECT_FALSE(read_text(scratch.path / "both" / path).empty());
  }
}

TEST(SinglePrecision, IsAbsentFromModulesOfPython) {
  const Scratch scratch("single-precision-python");
  const Outcome run = run_tool(
      "generate " + quoted(robot("hyl_parametric")) + " -o " + quoted(scratch.path) +
      " --language cpp python --name it");
  EXPECT_EQ(run.status, 0) << run.errors;
  const std::string text = read_text(scratch.path / "python" / "it.cpp");
  EXPECT_NE(text.find("&one_inverse_dynamics<double>, nullptr"), std::string::npos);
  EXPECT_EQ(text.find("float"), std::string::npos);
}

}  // namespace
}  // namespace robcogen::test::single_precision_test
