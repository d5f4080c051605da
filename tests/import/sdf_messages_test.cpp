// Every message of the SDF import, as a user sees it: sdf_bad/<name>.sdf must produce exactly the messages in its file.
// `-free-mimic` in the name sets that option, `-snap` another, `-checked` has shapes checked, and `-robot-x` at its end
// chooses robot x.
#include "import/sdf.h"
#include "patterns.h"
#include "reading.h"

namespace robcogen::sdf_messages_test {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "sdf_bad";
}

class SdfMessages : public testing::TestWithParam<path> {};

TEST_P(SdfMessages, AreAsExpected) {
  const path& file = GetParam();
  const std::string name = file.stem().string();
  import::SdfOptions options;
  options.free_mimic_joints = name.find("-free-mimic") != std::string::npos;
  options.snap_angles = name.find("-snap") != std::string::npos;
  options.shapes.visuals = options.shapes.collisions = options.shapes.are_checked =
      name.find("-checked") != std::string::npos;
  if (const std::size_t at = name.find("-robot-"); at != std::string::npos)
    options.robot = name.substr(at + sizeof "-robot-" - 1);
  Diagnostics diagnostics;
  const auto robot = import::sdf(test::source_of_golden(file), file, options, diagnostics);
  EXPECT_EQ(robot.has_value(), !diagnostics.has_errors());

  test::expect_messages(test::without_folder(diagnostics.render({.folds_notes = false}), folder()), file);
}

INSTANTIATE_TEST_SUITE_P(Bad, SdfMessages, testing::ValuesIn(test::files(folder(), {".sdf"})), test::test_name);

// Codes are the string literals in kebab case.
TEST(SdfMessages, OfEveryCodeHaveADocument) {
  const std::string kebab = R"re("([a-z]+(?:-[a-z]+)+)")re";
  std::set<std::string> codes;
  for (const path& file : test::files(path(ROBCOGEN_SOURCE_DIR) / "tool/import/sdf", {".cpp"}))
    codes.merge(test::matches(test::contents(file), kebab));
  codes.erase("sdf-unavailable");  // only from a generator without urdfdom
  test::expect_documents(codes, folder(), {".sdf"});
}

}  // namespace
}  // namespace robcogen::sdf_messages_test
