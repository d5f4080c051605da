// Every message of the model and of the import, as a user sees it: bad/<name>.kindsl, .motdsl or .ctdsl, with
// bad/<name>.dtdsl where the matter is a list of desired transforms, must yield exactly bad/<name>.expected (nothing
// for a document that is fine).
//
// With ROBCOGEN_ACCEPT_MESSAGES in the environment, the present messages are written to those files instead, for
// review.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <set>

#include "import/frames.h"
#include "reading.h"

namespace robcogen {
namespace {

using std::filesystem::path;

path folder() {
  return path(TEST_SOURCE_DIR) / "bad";
}

std::vector<std::string> names(const std::set<std::string>& extensions) {
  std::vector<std::string> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (extensions.contains(entry.path().extension().string())) result.push_back(entry.path().stem().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

path file(const std::string& name, const std::string& extension) {
  return folder() / (name + extension);
}

// Reads a document of any of the languages into its model; whether that succeeded must agree with the messages.
void read_robot(const std::string& name, Diagnostics& diagnostics) {
  const auto tree = test::tree_of(test::source(file(name, ".kindsl")), diagnostics);
  EXPECT_EQ(tree.has_value(), !diagnostics.has_errors());
  const path list = file(name, ".dtdsl");
  if (!tree || !exists(list)) return;
  import::desired_transforms(language::desired::parse(test::source(list), diagnostics), *tree, diagnostics);
}

void read_motions(const std::string& name, Diagnostics& diagnostics) {
  const auto document = language::motion::parse(test::source(file(name, ".motdsl")), diagnostics);
  ASSERT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  const auto motions = import::rigid_motions(document, diagnostics);
  EXPECT_EQ(motions.has_value(), !diagnostics.has_errors());
  const path list = file(name, ".dtdsl");
  if (!motions || !exists(list)) return;
  const auto pairs = language::desired::parse(test::source(list), diagnostics);
  import::desired_frame_pairs(pairs, *motions, diagnostics);
}

void read_transforms(const std::string& name, Diagnostics& diagnostics) {
  const auto document = language::transforms::parse(test::source(file(name, ".ctdsl")), diagnostics);
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
  const path expected = file(GetParam(), ".expected");
  if (std::getenv("ROBCOGEN_ACCEPT_MESSAGES") != nullptr) {
    std::ofstream(expected, std::ios::binary) << diagnostics.render();
    GTEST_SKIP() << "wrote " << expected;
  }
  ASSERT_TRUE(exists(expected)) << expected << " is missing; the messages are\n" << diagnostics.render();
  EXPECT_EQ(diagnostics.render(), test::contents(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Bad,
    Messages,
    testing::ValuesIn(names({".kindsl", ".motdsl", ".ctdsl"})),
    [](const testing::TestParamInfo<std::string>& document) {
      std::string name = document.param;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) result.insert((*it)[1]);
  return result;
}

// Codes are the string literals in kebab case, and whatever is given literally to error() or warning().
TEST(Messages, OfEveryCodeHaveADocument) {
  const std::regex kebab(R"re("([a-z]+(?:-[a-z]+)+)")re"),
      reported(R"re((?:error|warning|note)\(\s*"([a-z]+(?:-[a-z]+)*)")re");
  std::set<std::string> codes;
  for (const char* phase : {"model", "import"}) {
    for (const auto& entry : std::filesystem::directory_iterator(path(ROBCOGEN_SOURCE_DIR) / "tool" / phase)) {
      if (!entry.is_regular_file()) continue;
      const std::string text = test::contents(entry.path());
      codes.merge(matches(text, kebab));
      codes.merge(matches(text, reported));
    }
  }
  EXPECT_GT(codes.size(), 30u) << "the codes were not found in the sources";
  std::set<std::string> shown;
  for (const std::string& name : names({".expected"})) {
    shown.merge(
        matches(test::contents(file(name, ".expected")), std::regex(R"re((?:error|warning|note): .*\[([a-z-]+)\])re")));
  }
  for (const std::string& code : codes) EXPECT_TRUE(shown.contains(code)) << "no document yields [" << code << "]";
}

TEST(Messages, ThatAStrictReadingMakesErrorsAreThoseOfTheList) {
  Diagnostics diagnostics;
  const auto tree = test::tree_of(test::source(file("unknown-frame", ".kindsl")), diagnostics);
  ASSERT_TRUE(tree.has_value());
  for (const std::string& code : import::lenient_codes()) {
    Diagnostics of_list;
    const auto document = language::desired::parse(test::source(file(code, ".dtdsl")), of_list);
    import::desired_transforms(document, *tree, of_list);
    EXPECT_FALSE(of_list.has_errors()) << code;
    of_list.promote_warnings(import::lenient_codes());
    EXPECT_EQ(of_list.error_count(), of_list.all().size()) << code;
    EXPECT_GT(of_list.error_count(), 0u) << code;
  }
}

}  // namespace
}  // namespace robcogen
