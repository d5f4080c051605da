// Every message of the model and of the import, as a user sees it: bad/<name>.kindsl, .motdsl or .ctdsl, with
// bad/<name>.dtdsl for messages about desired transforms, must produce exactly bad/<name>.expected (nothing if the
// document is correct).
#include "import/frames.h"
#include "reading.h"

namespace robcogen {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "bad";
}

path file(const std::string& name, const std::string& extension) {
  return folder() / (name + extension);
}

// Reads a document of any language into its model; the model exists if and only if there are no errors.
void read_robot(const std::string& name, Diagnostics& diagnostics) {
  const auto tree = test::tree_of(test::source_of_file(file(name, ".kindsl")), diagnostics);
  EXPECT_EQ(tree.has_value(), !diagnostics.has_errors());
  const path list = file(name, ".dtdsl");
  if (!tree || !exists(list)) return;
  import::desired_transforms(language::desired::parse(test::source_of_file(list), diagnostics), *tree, diagnostics);
}

void read_motions(const std::string& name, Diagnostics& diagnostics) {
  const auto document = language::motion::parse(test::source_of_file(file(name, ".motdsl")), diagnostics);
  ASSERT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  const auto motions = import::rigid_motions(document, diagnostics);
  EXPECT_EQ(motions.has_value(), !diagnostics.has_errors());
  const path list = file(name, ".dtdsl");
  if (!motions || !exists(list)) return;
  const auto pairs = language::desired::parse(test::source_of_file(list), diagnostics);
  import::desired_frame_pairs(pairs, *motions, diagnostics);
}

void read_transforms(const std::string& name, Diagnostics& diagnostics) {
  const auto document = language::transforms::parse(test::source_of_file(file(name, ".ctdsl")), diagnostics);
  ASSERT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  const auto transforms = import::coordinate_transforms(document, diagnostics);
  EXPECT_EQ(transforms.has_value(), !diagnostics.has_errors());
}

class Messages : public testing::TestWithParam<std::string> {};

TEST_P(Messages, AreAsExpected) {
  Diagnostics diagnostics;
  if (exists(file(GetParam(), ".motdsl"))) {
    read_motions(GetParam(), diagnostics);
  } else if (exists(file(GetParam(), ".ctdsl"))) {
    read_transforms(GetParam(), diagnostics);
  } else {
    read_robot(GetParam(), diagnostics);
  }
  test::expect_messages(diagnostics.render(), file(GetParam(), ".expected"));
}

INSTANTIATE_TEST_SUITE_P(
    Bad,
    Messages,
    testing::ValuesIn(test::stems(folder(), {".kindsl", ".motdsl", ".ctdsl"})),
    test::test_name);

// Codes are the string literals in kebab case and all literals passed to error() or warning().
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::regex kebab(R"re("([a-z]+(?:-[a-z]+)+)")re"),
      reported(R"re((?:error|warning|note)\(\s*"([a-z]+(?:-[a-z]+)*)")re");
  std::set<std::string> codes;
  for (const char* phase : {"model", "import"}) {
    for (const path& file : test::files(path(ROBCOGEN_SOURCE_DIR) / "tool" / phase, {".cpp", ".h"})) {
      const std::string text = test::contents(file);
      codes.merge(test::matches(text, kebab));
      codes.merge(test::matches(text, reported));
    }
  }
  test::expect_documents(codes, folder());
}

TEST(Messages, ThatAStrictReadingMakesErrorsAreThoseOfTheList) {
  Diagnostics diagnostics;
  const auto tree = test::tree_of(test::source_of_file(file("unknown-frame", ".kindsl")), diagnostics);
  ASSERT_TRUE(tree.has_value());
  for (const std::string& code : import::lenient_codes()) {
    Diagnostics of_list;
    const auto document = language::desired::parse(test::source_of_file(file(code, ".dtdsl")), of_list);
    import::desired_transforms(document, *tree, of_list);
    EXPECT_FALSE(of_list.has_errors()) << code;
    of_list.promote_warnings(import::lenient_codes());
    EXPECT_EQ(of_list.error_count(), of_list.all().size()) << code;
    EXPECT_GT(of_list.error_count(), 0u) << code;
  }
}

}  // namespace
}  // namespace robcogen
