// Every message of the model and of the import, as a user sees it: each document in bad/ (.kindsl, .motdsl or .ctdsl),
// with the list of desired transforms in the same file, if any, must produce exactly the messages in that file.
#include "import/frames.h"
#include "patterns.h"
#include "reading.h"

namespace robcogen::messages_test {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "bad";
}

const std::set<std::string>& extensions() {
  static const std::set<std::string> all = {".kindsl", ".motdsl", ".ctdsl"};
  return all;
}

// The list of desired transforms in a file, as if it were in <name>.dtdsl; null if there is none.
std::shared_ptr<const Source> list_of(path file) {
  const std::optional<std::string> list = test::golden_at(file).list;
  return list ? std::make_shared<Source>(file.replace_extension(".dtdsl").filename().string(), *list) : nullptr;
}

// Reads a document of any language into its model; the model exists if and only if there are no errors.
void read_robot(const path& file, Diagnostics& diagnostics) {
  const auto tree = test::tree_of(test::source_of_golden(file), diagnostics);
  EXPECT_EQ(tree.has_value(), !diagnostics.has_errors());
  const auto list = list_of(file);
  if (!tree || !list) return;
  import::desired_transforms(language::desired::parse(list, diagnostics), *tree, diagnostics);
}

void read_motions(const path& file, Diagnostics& diagnostics) {
  const auto document = language::motion::parse(test::source_of_golden(file), diagnostics);
  ASSERT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  const auto motions = import::rigid_motions(document, diagnostics);
  EXPECT_EQ(motions.has_value(), !diagnostics.has_errors());
  const auto list = list_of(file);
  if (!motions || !list) return;
  import::desired_frame_pairs(language::desired::parse(list, diagnostics), *motions, diagnostics);
}

void read_transforms(const path& file, Diagnostics& diagnostics) {
  const auto document = language::transforms::parse(test::source_of_golden(file), diagnostics);
  ASSERT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  const auto transforms = import::coordinate_transforms(document, diagnostics);
  EXPECT_EQ(transforms.has_value(), !diagnostics.has_errors());
}

class Messages : public testing::TestWithParam<path> {};

TEST_P(Messages, AreAsExpected) {
  Diagnostics diagnostics;
  if (GetParam().extension() == ".motdsl") {
    read_motions(GetParam(), diagnostics);
  } else if (GetParam().extension() == ".ctdsl") {
    read_transforms(GetParam(), diagnostics);
  } else {
    read_robot(GetParam(), diagnostics);
  }
  test::expect_messages(diagnostics.render({.folds_notes = false}), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Bad, Messages, testing::ValuesIn(test::files(folder(), extensions())), test::test_name);

// Codes are the string literals in kebab case and all literals passed to error() or warning().
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::string kebab = R"re("([a-z]+(?:-[a-z]+)+)")re",
                    reported = R"re((?:error|warning|note)\(\s*"([a-z]+(?:-[a-z]+)*)")re";
  std::set<std::string> codes;
  for (const char* phase : {"model", "import"}) {
    for (const path& file : test::files(path(ROBCOGEN_SOURCE_DIR) / "tool" / phase, {".cpp", ".h"})) {
      const std::string text = test::contents(file);
      codes.merge(test::matches(text, kebab));
      codes.merge(test::matches(text, reported));
    }
  }
  // Codes of options, which robcogen_driver_test gives.
  std::erase_if(codes, [](const std::string& code) { return code.starts_with("lock"); });
  for (const char* code :
       {"unmatched-frame", "parameter-syntax", "parameter-quantity", "parameter-element", "parameter-rotor",
        "parameter-name", "parameter-unused", "angle-snapped", "angles-near-multiples"})
    codes.erase(code);
  test::expect_documents(codes, folder(), extensions());
}

TEST(Messages, ThatAStrictReadingMakesErrorsAreThoseOfTheList) {
  Diagnostics diagnostics;
  const auto tree = test::tree_of(test::source_of_golden(folder() / "unknown-frame.kindsl"), diagnostics);
  ASSERT_TRUE(tree.has_value());
  for (const std::string& code : import::lenient_codes()) {
    Diagnostics of_list;
    const auto list = list_of(folder() / (code + ".kindsl"));
    ASSERT_TRUE(list) << code;
    const auto document = language::desired::parse(list, of_list);
    import::desired_transforms(document, *tree, of_list);
    EXPECT_FALSE(of_list.has_errors()) << code;
    of_list.promote_warnings(import::lenient_codes());
    EXPECT_EQ(of_list.error_count(), of_list.all().size()) << code;
    EXPECT_GT(of_list.error_count(), 0u) << code;
  }
}

}  // namespace
}  // namespace robcogen::messages_test
