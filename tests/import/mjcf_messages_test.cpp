// Every message of the MJCF import, as a user sees it: mjcf_bad/<name>.xml must produce exactly the messages in its
// file. `-free-mimic` in the name sets that option.
#include "import/mjcf.h"
#include "reading.h"

namespace robcogen {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "mjcf_bad";
}

// Returns the messages with the names of included files relative to the folder.
std::string without_folder(std::string text) {
  const std::string prefix = folder().lexically_normal().string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

class MjcfMessages : public testing::TestWithParam<path> {};

TEST_P(MjcfMessages, AreAsExpected) {
  const path& file = GetParam();
  const import::MjcfOptions options{
      .free_equality_joints = file.stem().string().find("-free-mimic") != std::string::npos};
  Diagnostics diagnostics;
  const auto robot = import::mjcf(test::source_of_golden(file), file, options, diagnostics);
  EXPECT_EQ(robot.has_value(), !diagnostics.has_errors());

  test::expect_messages(without_folder(diagnostics.render()), file);
}

INSTANTIATE_TEST_SUITE_P(Bad, MjcfMessages, testing::ValuesIn(test::files(folder(), {".xml"})), test::test_name);

// Codes are the string literals in kebab case.
TEST(MjcfMessages, OfEveryCodeHaveADocument) {
  const std::regex kebab(R"re("([a-z]+(?:-[a-z]+)+)")re");
  std::set<std::string> codes;
  for (const path& file : test::files(path(ROBCOGEN_SOURCE_DIR) / "tool/import/mjcf", {".cpp"}))
    codes.merge(test::matches(test::contents(file), kebab));
  codes.erase("mjcf-unavailable");  // only from a generator without urdfdom
  test::expect_documents(codes, folder(), {".xml"});
}

}  // namespace
}  // namespace robcogen
