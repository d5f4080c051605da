// Every message about parts and imports, as a user sees it: bad/<name>.kindsl must yield exactly the messages in its
// file. Documents that others import are in bad/imported; they have no messages of their own.
#include "../golden_messages.h"
#include "import/kinematics.h"
#include "import/parts.h"
#include "patterns.h"

namespace robcogen::messages_test {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "bad";
}

// Files are named relative to the folder.
std::string messages_of(const path& document) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<Source>(document.string(), test::golden_at(document).document);
  const auto read = import::robot_document(source, {}, diagnostics);
  EXPECT_EQ(read.has_value(), !diagnostics.has_errors());
  if (read) import::kinematic_tree(read->document, diagnostics);
  std::string text = diagnostics.render({.folds_notes = false});
  const std::string prefix = folder().string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

class Messages : public testing::TestWithParam<path> {};

TEST_P(Messages, AreAsExpected) {
  test::expect_messages(messages_of(GetParam()), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Bad, Messages, testing::ValuesIn(test::files(folder(), {".kindsl"})), test::test_name);

// A code is the first literal that is given to error() or warning().
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::string reported = R"re((?:error|warning)\(\s*"([a-z]+(?:-[a-z]+)*)")re";
  std::set<std::string> codes;
  for (const path& file : test::files(path(ROBCOGEN_SOURCE_DIR) / "tool" / "import" / "parts", {".cpp", ".h"}))
    codes.merge(test::matches(test::contents(file), reported));
  test::expect_documents(codes, folder(), {".kindsl"}, 15);
}

}  // namespace
}  // namespace robcogen::messages_test
