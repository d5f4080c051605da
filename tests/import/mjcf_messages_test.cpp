// Every message of the import of MJCF, as a user sees it: mjcf_bad/<name>.xml must yield exactly
// mjcf_bad/<name>.expected. `-free-mimic` in the name asks for that option.
//
// With ROBCOGEN_ACCEPT_MESSAGES in the environment, the present messages are written to those files instead, for
// review.
#include <cstdlib>
#include <regex>
#include <set>

#include "import/mjcf.h"
#include "reading.h"

namespace robcogen {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "mjcf_bad";
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const path& file : test::files(folder(), ".xml")) result.push_back(file.stem().string());
  return result;
}

// Of the messages, names of included files as if they were read in the folder.
std::string without_folder(std::string text) {
  const std::string prefix = folder().lexically_normal().string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

class MjcfMessages : public testing::TestWithParam<std::string> {};

TEST_P(MjcfMessages, AreAsExpected) {
  const path file = folder() / (GetParam() + ".xml");
  const import::MjcfOptions options{.free_equality_joints = GetParam().find("-free-mimic") != std::string::npos};
  Diagnostics diagnostics;
  const auto robot = import::mjcf(test::source(file), file, options, diagnostics);
  EXPECT_EQ(robot.has_value(), !diagnostics.has_errors());

  const path expected = folder() / (GetParam() + ".expected");
  const std::string messages = without_folder(diagnostics.render());
  if (std::getenv("ROBCOGEN_ACCEPT_MESSAGES") != nullptr) {
    std::ofstream(expected, std::ios::binary) << messages;
    GTEST_SKIP() << "wrote " << expected;
  }
  ASSERT_TRUE(exists(expected)) << expected << " is missing; the messages are\n" << messages;
  EXPECT_EQ(messages, test::contents(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Bad,
    MjcfMessages,
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

// Codes are the string literals in kebab case.
TEST(MjcfMessages, OfEveryCodeHaveADocument) {
  const std::regex kebab(R"re("([a-z]+(?:-[a-z]+)+)")re");
  std::set<std::string> codes;
  for (const path& file : test::files(path(ROBCOGEN_SOURCE_DIR) / "tool/import/mjcf", ".cpp"))
    codes.merge(matches(test::contents(file), kebab));
  codes.erase("mjcf-unavailable");  // of a generator without urdfdom
  EXPECT_GT(codes.size(), 30u) << "the codes were not found in the sources";
  std::set<std::string> shown;
  for (const path& file : test::files(folder(), ".expected"))
    shown.merge(matches(test::contents(file), std::regex(R"re((?:error|warning|note): .*\[([a-z-]+)\])re")));
  for (const std::string& code : codes) EXPECT_TRUE(shown.contains(code)) << "no document yields [" << code << "]";
}

}  // namespace
}  // namespace robcogen
