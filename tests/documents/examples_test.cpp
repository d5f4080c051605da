// The examples of runtime/README.md compile.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "markdown.h"

namespace robcogen::test {
namespace {

namespace fs = std::filesystem;

// A function for each section. Declarations of the first one are visible in the others, too; templates and includes
// stand before all.
std::string program(const std::vector<CodeBlock>& blocks) {
  std::string includes, templates, functions, first, section, body;
  int count = 0;
  const auto finish = [&] {
    if (body.empty()) return;
    functions += "void section_" + std::to_string(++count) + "() {\n" + first + "{\n" + body + "}\n}\n";
    if (first.empty()) first = body;
    body.clear();
  };
  for (const CodeBlock& block : blocks) {
    if (block.language != "cpp") continue;
    if (block.section != section) finish();
    section = block.section;
    std::istringstream lines(block.text);
    std::string& rest = block.text.find("template <") == std::string::npos ? body : templates;
    for (std::string line; std::getline(lines, line);) (line.starts_with("#include") ? includes : rest) += line + "\n";
  }
  finish();
  return includes + templates + functions;
}

TEST(Examples, OfTheGeneratedCodeCompile) {
  const fs::path folder = scratch("examples");
  fs::remove_all(folder);
  const std::string robots = ROBCOGEN_SOURCE_DIR "/robots/";
  fs::create_directories(folder);
  for (const CodeBlock& block : code_blocks(read_text(source_folder() / "tool/language/README.md")))
    if (block.language == "motdsl") std::ofstream(folder / "crane.motdsl") << block.text;
  for (const std::string& arguments :
       {robots + "hyl/hyl.kindsl --name hyl --batch --algorithms all --desired " + robots + "hyl/hyl.dtdsl",
        robots + "hyl_parametric/hyl_parametric.kindsl --name hyl_parametric",
        robots + "quadruped/quadruped.kindsl --name quadruped", (folder / "crane.motdsl").string() + " --name crane"}) {
    int status = 0;
    const std::string output =
        output_of("'" ROBCOGEN_TOOL "' generate -o '" + folder.string() + "' " + arguments, status);
    ASSERT_EQ(status, 0) << output;
  }
  const std::string text = program(code_blocks(read_text(source_folder() / "runtime/README.md")));
  std::ofstream(folder / "examples.cpp") << text;
  int status = 0;
  const std::string output = output_of(
      "'" ROBCOGEN_CXX "' -std=c++20 -fsyntax-only -I '" + folder.string() +
          "' -I '" ROBCOGEN_SOURCE_DIR "/runtime/include' -isystem '" ROBCOGEN_EIGEN "' '" +
          (folder / "examples.cpp").string() + "'",
      status);
  EXPECT_EQ(status, 0) << output;
  EXPECT_NE(text.find("section_9"), std::string::npos) << "too few sections have examples";
  if (!testing::Test::HasFailure()) fs::remove_all(folder);
}

}  // namespace
}  // namespace robcogen::test
