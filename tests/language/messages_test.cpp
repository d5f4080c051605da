// Every message of the parsers, as a user sees it: bad/<name>.kindsl, .dtdsl, .motdsl or .ctdsl must produce exactly
// bad/<name>.expected (nothing if the document is correct). not-original.kindsl is read as by `print --original`.
#include "language/kinematics/original.h"
#include "reading.h"

namespace robcogen {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "bad";
}

const std::set<std::string>& extensions() {
  static const std::set<std::string> all = {".kindsl", ".dtdsl", ".motdsl", ".ctdsl"};
  return all;
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
  test::expect_messages(messages_of(GetParam()), path(GetParam()).replace_extension(".expected"));
}

INSTANTIATE_TEST_SUITE_P(
    Bad,
    Messages,
    testing::ValuesIn(test::files(folder(), extensions())),
    [](const testing::TestParamInfo<path>& document) {
      return test::test_name({document.param.stem().string(), document.index});
    });

// A code is the first literal passed to error(), error_at() or warning_at(), possibly after a span.
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::regex reported(R"re((?:error|error_at|warning_at)\(\s*(?:[^";]*,\s*)?"([a-z0-9]+(?:-[a-z0-9]+)*)",)re");
  std::set<std::string> codes;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(path(ROBCOGEN_SOURCE_DIR) / "tool" / "language")) {
    if (entry.path().extension() == ".cpp") codes.merge(test::matches(test::contents(entry.path()), reported));
  }
  test::expect_documents(codes, folder());
  for (const std::string& code : test::shown_codes(folder()))
    EXPECT_TRUE(codes.contains(code)) << "[" << code << "] was not found in the sources";
}

// Every file of messages belongs to a document; a stray file would never be checked.
TEST(Messages, BelongToADocument) {
  for (const path& expected : test::files(folder(), {".expected"})) {
    int documents = 0;
    for (const std::string& extension : extensions())
      documents += exists(path(expected).replace_extension(extension)) ? 1 : 0;
    EXPECT_EQ(documents, 1) << expected;
  }
}

}  // namespace
}  // namespace robcogen
