// Every message of the parsers, as a user sees it: each document in bad/ (.kindsl, .dtdsl, .motdsl or .ctdsl) must
// produce exactly the messages in its file. not-original.kindsl is read as by `print --original`.
#include "language/kinematics/original.h"
#include "patterns.h"
#include "reading.h"

namespace robcogen::messages_test {
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
    language::desired::parse(test::source_of_golden(document), diagnostics);
  } else if (document.extension() == ".motdsl") {
    language::motion::parse(test::source_of_golden(document), diagnostics);
  } else if (document.extension() == ".ctdsl") {
    language::transforms::parse(test::source_of_golden(document), diagnostics);
  } else {
    const auto robot = language::kinematics::parse(test::source_of_golden(document), diagnostics);
    if (document.stem() == "not-original") language::kinematics::is_original(robot, diagnostics);
  }
  return diagnostics.render({.folds_notes = false});
}

class Messages : public testing::TestWithParam<path> {};

TEST_P(Messages, AreAsExpected) {
  test::expect_messages(messages_of(GetParam()), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Bad, Messages, testing::ValuesIn(test::files(folder(), extensions())), test::test_name);

// A code is the first literal passed to error(), error_at() or warning_at(), possibly after a span.
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::string reported = R"re((?:error|error_at|warning_at)\(\s*(?:[^";]*,\s*)?"([a-z0-9]+(?:-[a-z0-9]+)*)",)re";
  std::set<std::string> codes;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(path(ROBCOGEN_SOURCE_DIR) / "tool" / "language")) {
    if (entry.path().extension() == ".cpp") codes.merge(test::matches(test::contents(entry.path()), reported));
  }
  test::expect_documents(codes, folder(), extensions());
  for (const std::string& code : test::shown_codes(folder(), extensions()))
    EXPECT_TRUE(codes.contains(code)) << "[" << code << "] was not found in the sources";
}

// The format of these files: see golden.h.
TEST(Golden, KeepsEveryByteOfADocument) {
  using namespace std::string_literals;
  for (const std::string& document :
       {""s, "\n"s, "a"s, "a\n"s, "a\n\n"s,
        "\xEF\xBB\xBF"
        "a\r\n"s,
        "\0\n\0"s, "/* a"s, " ==== messages ====\n"s, "====\n=== a ====\n"s, std::string(100'000, '=')}) {
    for (const auto& list : {std::optional<std::string>(), {""s}, {"b"s}, {"b\n"s}}) {
      for (const auto& messages : {std::optional<std::string>(), {""s}, {"c: error: d [e]\n"s}}) {
        if (list && !messages) continue;  // a list always has messages
        const test::Golden read = test::golden_of(text_of(test::Golden{document, list, messages}));
        EXPECT_EQ(read.document, document);
        EXPECT_EQ(read.list, list);
        EXPECT_EQ(read.messages, messages);
      }
    }
  }
  for (const path& file : test::files(folder(), extensions()))
    EXPECT_EQ(text_of(test::golden_at(file)), test::contents(file)) << file;
}

TEST(Golden, RefusesMarkersThatItDoesNotKnow) {
  for (const char* text :
       {"a\n==== message ====\n", "==== messages\n", "==== messages ====\n==== list ====\n",
        "==== messages ====\n==== messages ====\n", "==== messages (no newline above) ====\n"})
    EXPECT_THROW(test::golden_of(text), std::runtime_error) << text;
}

}  // namespace
}  // namespace robcogen::messages_test
