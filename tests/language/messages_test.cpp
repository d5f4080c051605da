// Every message of the parsers, as a user sees it: bad/<name>.kindsl, .dtdsl, .motdsl or .ctdsl must yield exactly
// bad/<name>.expected (nothing for a document that is fine). not-original.kindsl is read as `print --original` does.
//
// With ROBCOGEN_ACCEPT_MESSAGES in the environment, the present messages are written to those files instead, for
// review.
#include <algorithm>
#include <cstdlib>
#include <regex>
#include <set>

#include "language/kinematics/original.h"
#include "reading.h"

namespace robcogen {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "bad";
}

std::vector<path> documents() {
  std::vector<path> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().extension() != ".expected") result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

std::string messages_of(const path& document) {
  Diagnostics diagnostics;
  if (document.extension() == ".dtdsl") {
    language::desired::parse(test::source_of_file(document), diagnostics);
  } else if (document.extension() == ".motdsl") {
    language::motion::parse(test::source_of_file(document), diagnostics);
  } else if (document.extension() == ".ctdsl") {
    language::transforms::parse(test::source_of_file(document), diagnostics);
  } else {
    const auto robot = language::kinematics::parse(test::source_of_file(document), diagnostics);
    if (document.stem() == "not-original") language::kinematics::is_original(robot, diagnostics);
  }
  return diagnostics.render();
}

class Messages : public testing::TestWithParam<path> {};

TEST_P(Messages, AreAsExpected) {
  const std::string messages = messages_of(GetParam());
  const path expected = path(GetParam()).replace_extension(".expected");
  if (std::getenv("ROBCOGEN_ACCEPT_MESSAGES") != nullptr) {
    std::ofstream(expected, std::ios::binary) << messages;
    GTEST_SKIP() << "wrote " << expected;
  }
  ASSERT_TRUE(exists(expected)) << expected << " is missing; the messages are\n" << messages;
  EXPECT_EQ(messages, test::contents(expected));
}

std::string test_name(const testing::TestParamInfo<path>& document) {
  std::string name = document.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Bad, Messages, testing::ValuesIn(documents()), test_name);

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) result.insert((*it)[1]);
  return result;
}

// A code is the first literal that is given to error(), error_at() or warning_at(); a span may stand before it.
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::regex reported(R"re((?:error|error_at|warning_at)\(\s*(?:[^";]*,\s*)?"([a-z0-9]+(?:-[a-z0-9]+)*)",)re");
  std::set<std::string> codes;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(path(ROBCOGEN_SOURCE_DIR) / "tool" / "language")) {
    if (entry.path().extension() == ".cpp") codes.merge(matches(test::contents(entry.path()), reported));
  }
  std::set<std::string> shown;
  const std::regex rendered(R"re((?:error|warning): .*\[([a-z0-9-]+)\]\n)re");
  for (const path& document : documents())
    shown.merge(matches(test::contents(path(document).replace_extension(".expected")), rendered));
  for (const std::string& code : codes) EXPECT_TRUE(shown.contains(code)) << "no document yields [" << code << "]";
  for (const std::string& code : shown)
    EXPECT_TRUE(codes.contains(code)) << "[" << code << "] was not found in the sources";
}

// Every file of messages belongs to a document: a stray file would not be checked.
TEST(Messages, BelongToADocument) {
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (entry.path().extension() != ".expected") continue;
    int documents = 0;
    for (const char* extension : {".kindsl", ".dtdsl", ".motdsl", ".ctdsl"})
      documents += exists(path(entry.path()).replace_extension(extension)) ? 1 : 0;
    EXPECT_EQ(documents, 1) << entry.path();
  }
}

}  // namespace
}  // namespace robcogen
