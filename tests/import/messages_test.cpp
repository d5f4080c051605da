// Every message of the URDF import, as a user sees it: bad/<name>.urdf must produce exactly the messages in its file.
// Words in the name set options: `-snap`, `-free-mimic`, `-floating-base`, `-allow-implausible`, `-checked`.
#include "import/urdf/document.h"
#include "patterns.h"
#include "reading.h"

namespace robcogen::messages_test {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "bad";
}

class Messages : public testing::TestWithParam<path> {};

TEST_P(Messages, AreAsExpected) {
  const auto asks_for = [&](const char* word) { return GetParam().stem().string().find(word) != std::string::npos; };
  import::UrdfOptions options;
  options.snap_angles = asks_for("-snap");
  options.free_mimic_joints = asks_for("-free-mimic");
  options.floating_base = asks_for("-floating-base");
  options.allow_implausible = asks_for("-allow-implausible");
  options.shapes.visuals = options.shapes.collisions = options.shapes.are_checked = asks_for("-checked");

  Diagnostics diagnostics;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const auto tree = import::urdf(test::source_of_golden(GetParam()), options, diagnostics);
  EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(tree.has_value(), !diagnostics.has_errors());

  test::expect_messages(diagnostics.render({.folds_notes = false}), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Bad, Messages, testing::ValuesIn(test::files(folder(), {".urdf"})), test::test_name);

// Codes are the string literals in kebab case and all literals passed to error(), warning() or note().
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::string kebab = R"re("([a-z]+(?:-[a-z]+)+)")re", reported = R"re((?:error|warning|note)\(\s*"([^"]+)")re";
  std::set<std::string> codes;
  for (const char* folder_of_reader : {"tool/import/urdf", "tool/import/xml"}) {
    for (const path& file : test::files(path(ROBCOGEN_SOURCE_DIR) / folder_of_reader, {".cpp"})) {
      const std::string text = test::contents(file);
      codes.merge(test::matches(text, kebab));
      codes.merge(test::matches(text, reported));
    }
  }
  codes.erase("duplicate-name");  // only the readers of MJCF and SDF report these two
  codes.erase("unknown-word");
  codes.erase("urdf-unavailable");  // only from a generator without urdfdom
  codes.erase("urdfdom");           // only if urdfdom refuses what this reader accepts: see the next test
  test::expect_documents(codes, folder(), {".urdf"});
}

TEST(Messages, QuoteUrdfdom) {
  import::from_urdf::Document document;
  document.source = std::make_shared<Source>("arm.urdf", "<robot name=\"arm\"/>");
  document.name = {"arm", {document.source, {13, 16}}};
  Diagnostics diagnostics;
  EXPECT_TRUE(read_limits(document, diagnostics).empty());
  EXPECT_EQ(
      diagnostics.render(),
      "arm.urdf:1:14: error: urdfdom rejects this robot: No link elements found in urdf file [urdfdom]\n"
      "    <robot name=\"arm\"/>\n"
      "                 ^~~\n");
}

}  // namespace
}  // namespace robcogen::messages_test
