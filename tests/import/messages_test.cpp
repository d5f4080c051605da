// Every message of the import of URDFs, as a user sees it: bad/<name>.urdf must yield exactly bad/<name>.expected.
// Words in the name ask for options: `-snap`, `-free-mimic`, `-floating-base`.
//
// With ROBCOGEN_ACCEPT_MESSAGES in the environment, the present messages are written to those files instead, for
// review.
#include <cstdlib>
#include <regex>
#include <set>

#include "reading.h"

namespace robcogen {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "bad";
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const path& file : test::files(folder(), ".urdf")) result.push_back(file.stem().string());
  return result;
}

class Messages : public testing::TestWithParam<std::string> {};

TEST_P(Messages, AreAsExpected) {
  const auto asks_for = [&](const char* word) { return GetParam().find(word) != std::string::npos; };
  import::UrdfOptions options;
  options.snap_angles = asks_for("-snap");
  options.free_mimic_joints = asks_for("-free-mimic");
  options.floating_base = asks_for("-floating-base");
  options.allow_implausible = asks_for("-allow-implausible");

  Diagnostics diagnostics;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const auto tree = import::urdf(test::source(folder() / (GetParam() + ".urdf")), options, diagnostics);
  EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(tree.has_value(), !diagnostics.has_errors());

  const path expected = folder() / (GetParam() + ".expected");
  if (std::getenv("ROBCOGEN_ACCEPT_MESSAGES") != nullptr) {
    std::ofstream(expected, std::ios::binary) << diagnostics.render();
    GTEST_SKIP() << "wrote " << expected;
  }
  ASSERT_TRUE(exists(expected)) << expected << " is missing; the messages are\n" << diagnostics.render();
  EXPECT_EQ(diagnostics.render(), test::contents(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Bad,
    Messages,
    testing::ValuesIn(names()),
    [](const testing::TestParamInfo<std::string>& document) {
      std::string name = document.param;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) result.insert((*it)[1]);
  return result;
}

// Codes are the string literals in kebab case, and whatever is given literally to error(), warning() or note().
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::regex kebab(R"re("([a-z]+(?:-[a-z]+)+)")re"), reported(R"re((?:error|warning|note)\(\s*"([^"]+)")re");
  std::set<std::string> codes;
  for (const path& file : test::files(path(ROBCOGEN_SOURCE_DIR) / "tool/import/urdf", ".cpp")) {
    const std::string text = test::contents(file);
    codes.merge(matches(text, kebab));
    codes.merge(matches(text, reported));
  }
  codes.erase("urdf-unavailable");  // of a generator without urdfdom
  EXPECT_GT(codes.size(), 30u) << "the codes were not found in the sources";
  std::set<std::string> shown;
  for (const path& file : test::files(folder(), ".expected")) {
    shown.merge(matches(test::contents(file), std::regex(R"re((?:error|warning|note): .*\[([a-z-]+)\])re")));
  }
  for (const std::string& code : codes) EXPECT_TRUE(shown.contains(code)) << "no document yields [" << code << "]";
}

}  // namespace
}  // namespace robcogen
