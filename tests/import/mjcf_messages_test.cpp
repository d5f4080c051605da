// Every message of the MJCF import, as a user sees it: mjcf_bad/<name>.xml must produce exactly the messages in its
// file. `-free-mimic` in the name sets that option, `-checked` has shapes checked, and `-robot-x` at its end chooses
// robot x.
#include "import/mjcf.h"
#include "patterns.h"
#include "reading.h"

namespace robcogen::mjcf_messages_test {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "mjcf_bad";
}

class MjcfMessages : public testing::TestWithParam<path> {};

TEST_P(MjcfMessages, AreAsExpected) {
  const path& file = GetParam();
  const std::string name = file.stem().string();
  import::MjcfOptions options;
  options.free_equality_joints = name.find("-free-mimic") != std::string::npos;
  options.shapes.visuals = options.shapes.collisions = options.shapes.are_checked =
      name.find("-checked") != std::string::npos;
  if (const std::size_t at = name.find("-robot-"); at != std::string::npos)
    options.robot = name.substr(at + sizeof "-robot-" - 1);
  Diagnostics diagnostics;
  const auto robot = import::mjcf(test::source_of_golden(file), file, options, diagnostics);
  EXPECT_EQ(robot.has_value(), !diagnostics.has_errors());

  test::expect_messages(test::without_folder(diagnostics.render({.folds_notes = false}), folder()), file);
}

INSTANTIATE_TEST_SUITE_P(Bad, MjcfMessages, testing::ValuesIn(test::files(folder(), {".xml"})), test::test_name);

// Codes are the string literals in kebab case.
TEST(MjcfMessages, OfEveryCodeHaveADocument) {
  const std::string kebab = R"re("([a-z]+(?:-[a-z]+)+)")re";
  std::set<std::string> codes;
  for (const path& file : test::files(path(ROBCOGEN_SOURCE_DIR) / "tool/import/mjcf", {".cpp"}))
    codes.merge(test::matches(test::contents(file), kebab));
  codes.erase("mjcf-unavailable");  // only from a generator without urdfdom
  test::expect_documents(codes, folder(), {".xml"});
}

}  // namespace
}  // namespace robcogen::mjcf_messages_test
