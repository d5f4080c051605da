// The first listing of README.md is the output of the generator.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "markdown.h"

namespace robcogen::test::listing_test {
namespace {

namespace fs = std::filesystem;

// The statements of a kernel's first function, from the first comment in its body to its end.
std::string statements(const std::string& kernel) {
  const std::size_t body = kernel.find(") noexcept {\n");
  const std::size_t begin = kernel.find("\n  // ", body) + 1, end = kernel.find("\n}\n", begin) + 1;
  if (body == std::string::npos || begin == 0 || end == 0) return "";
  return kernel.substr(begin, end - begin);
}

TEST(Listing, IsWhatTheGeneratorPrints) {
  const fs::path folder = code_of_hyl("listing", "--algorithms joint_space_inertia");
  const std::string printed = statements(read_text(folder / "hyl/kernel/joint_space_inertia.h"));
  fs::remove_all(folder);
  ASSERT_NE(printed, "") << "no function with a comment in its body";

  const fs::path path = source_folder() / "README.md";
  std::string readme = read_text(path);
  const std::string fence = "```cpp\n";
  const std::size_t begin = readme.find(fence, readme.find("<!-- Printed by the generator")) + fence.size();
  const std::string shown = readme.substr(begin, readme.find("```", begin) - begin);
  if (std::getenv("ROBCOGEN_UPDATE_DOCUMENTS")) {
    readme.replace(begin, shown.size(), printed);
    std::ofstream(path, std::ios::binary) << readme;
    return;
  }
  EXPECT_EQ(shown, printed) << "the listing of README.md is not what the generator prints now: build the target "
                               "update_documents, look at the difference, and commit it";
}

}  // namespace
}  // namespace robcogen::test::listing_test
