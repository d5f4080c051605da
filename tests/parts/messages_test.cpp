// Every message about parts and imports, as a user sees it: bad/<name>.kindsl must yield exactly bad/<name>.expected
// (nothing for a document that is fine). Documents that others import are in bad/imported.
//
// With ROBCOGEN_ACCEPT_MESSAGES in the environment, the present messages are written to those files instead, for
// review.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "import/kinematics.h"
#include "import/parts.h"

namespace robcogen {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "bad";
}

std::string contents(const path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<path> documents() {
  std::vector<path> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().extension() == ".kindsl") result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

// Files are called by their names below the folder.
std::string messages_of(const path& document) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<Source>(document.string(), contents(document));
  const auto read = import::robot_document(source, {}, diagnostics);
  EXPECT_EQ(read.has_value(), !diagnostics.has_errors());
  if (read) import::kinematic_tree(read->document, diagnostics);
  std::string text = diagnostics.render();
  const std::string prefix = folder().string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
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
  EXPECT_EQ(messages, contents(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Bad,
    Messages,
    testing::ValuesIn(documents()),
    [](const testing::TestParamInfo<path>& document) {
      std::string name = document.param.stem().string();
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) result.insert((*it)[1]);
  return result;
}

// A code is the first literal that is given to error() or warning().
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::regex reported(R"re((?:error|warning)\(\s*"([a-z]+(?:-[a-z]+)*)")re");
  std::set<std::string> codes;
  for (const auto& entry : std::filesystem::directory_iterator(path(ROBCOGEN_SOURCE_DIR) / "tool" / "import" / "parts"))
    codes.merge(matches(contents(entry.path()), reported));
  EXPECT_GT(codes.size(), 15u) << "the codes were not found in the sources";
  std::set<std::string> shown;
  const std::regex rendered(R"re((?:error|warning): .*\[([a-z-]+)\]\n)re");
  for (const path& document : documents())
    shown.merge(matches(contents(path(document).replace_extension(".expected")), rendered));
  for (const std::string& code : codes) EXPECT_TRUE(shown.contains(code)) << "no document yields [" << code << "]";
}

}  // namespace
}  // namespace robcogen
