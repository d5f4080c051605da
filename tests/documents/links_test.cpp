// Every relative link of every guide leads to an existing file or folder of the project, and to an existing heading.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "markdown.h"
#include "patterns.h"

namespace robcogen::test::links_test {
namespace {

namespace fs = std::filesystem;

// Returns what is wrong with a link in this guide; empty if it is right.
std::string fault(const fs::path& guide, const std::string& link) {
  const std::string file = link.substr(0, link.find('#'));
  const fs::path target =
      file.empty() ? source_folder() / guide : (source_folder() / guide.parent_path() / file).lexically_normal();
  if (!fs::exists(target)) return "no such file";
  if (link.find('#') == std::string::npos) return "";
  const std::vector<std::string> headings = anchors(read_text(target));
  const std::string anchor = link.substr(link.find('#') + 1);
  return std::find(headings.begin(), headings.end(), anchor) == headings.end() ? "no such heading" : "";
}

TEST(Links, LeadToFilesAndHeadings) {
  // Link titles may contain `code`, which `without_code` removes, so the pattern does not read them.
  const std::string pattern = R"(\]\(([^)\s]+)\))";
  const std::vector<fs::path> all = guides();
  std::size_t count = 0;
  for (const fs::path& guide : all) {
    const std::string text = without_code(read_text(source_folder() / guide));
    for (const Match& match : all_matches(text, pattern)) {
      const std::string& link = match[1];
      if (link.starts_with("https://") || link.starts_with("http://")) continue;
      ++count;
      EXPECT_EQ(fault(guide, link), "") << guide << " links to " << link;
    }
  }
  EXPECT_GE(all.size(), 9);
  EXPECT_GE(count, 80);
}

TEST(Links, FaultsAreFound) {
  EXPECT_EQ(fault("README.md", "cmake/README.md#install"), "");
  EXPECT_EQ(fault("cmake/README.md", "../README.md"), "");
  EXPECT_EQ(fault("README.md", "cmake/NOTHING.md"), "no such file");
  EXPECT_EQ(fault("README.md", "cmake/README.md#instal"), "no such heading");
  EXPECT_EQ(fault("README.md", "#nothing"), "no such heading");
  EXPECT_EQ(
      anchors("# A `b_c`, D\n```sh\n# no heading\n```\n## URDF (x)\n# A `b_c`, D\n"),
      (std::vector<std::string>{"a-b_c-d", "urdf-x", "a-b_c-d-1"}));
}

}  // namespace
}  // namespace robcogen::test::links_test
