// A block of C++ in a guide of the generator that begins with the path of a file is part of this file: of the project,
// or of those that the generator prints for the robot hyl.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "markdown.h"
#include "patterns.h"

namespace robcogen::test::excerpts_test {
namespace {

namespace fs = std::filesystem;

// The folder with the generated code of hyl.
const fs::path& generated() {
  static const fs::path folder = code_of_hyl("excerpts");
  return folder;
}

// Returns what is wrong with a block; empty if it is right, or does not begin with a path.
std::string fault(const std::string& block) {
  const auto head = first_match(block, R"(^// ((tool|tests|hyl)/\S+)\n)");
  if (!head) return "";
  const fs::path file = ((*head)[2] == "hyl" ? generated() : source_folder()) / (*head)[1];
  if (!fs::exists(file)) return "no such file";
  return read_text(file).find(block.substr((*head)[0].size())) == std::string::npos ? "not in the file" : "";
}

TEST(Excerpts, AreInTheirFiles) {
  int count = 0;
  for (const char* guide : {"tool/README.md", "tool/backend/README.md"}) {
    const std::string text = read_text(source_folder() / guide);
    for (const Match& match : all_matches(text, "```cpp\n([^`]*)```")) {
      const std::string& block = match[1];
      if (block.starts_with("// ")) ++count;
      EXPECT_EQ(fault(block), "") << guide << ":\n" << block;
    }
  }
  EXPECT_GE(count, 6);
  fs::remove_all(generated());
}

TEST(Excerpts, FaultsAreFound) {
  EXPECT_EQ(fault("// tool/pass/kernel_form.h\n#pragma once\n"), "");
  EXPECT_EQ(fault("// tool/pass/kernel_form.h\n#pragma twice\n"), "not in the file");
  EXPECT_EQ(fault("// tool/pass/nothing.h\n"), "no such file");
  EXPECT_EQ(fault("int x;\n"), "");
}

}  // namespace
}  // namespace robcogen::test::excerpts_test
