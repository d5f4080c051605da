// Requirements on every language: it prints all functions of a library, in files with distinct paths.
#include "backend/languages.h"

#include <gtest/gtest.h>

#include <set>

#include "../../codegen/samples.h"
#include "patterns.h"

namespace robcogen::backend::languages_test {
namespace {

class Languages : public testing::TestWithParam<std::string> {
 protected:
  std::vector<OutputFile> print(const Library& library) const {
    for (const Language& language : languages())
      if (language.name == GetParam()) return language.print(library);
    return {};
  }
};

TEST_P(Languages, PrintEveryFunction) {
  for (const Library& library : {test::cart_pole(), test::hopper(), test::plinth()}) {
    std::set<std::string> words;
    for (const OutputFile& file : print(library))
      for (const robcogen::test::Match& word : robcogen::test::all_matches(file.text, "\\w+")) words.insert(word[0]);
    ASSERT_FALSE(library.functions.empty());
    for (const Function& f : library.functions)
      EXPECT_TRUE(
          words.contains(f.name) || words.contains(library.name + "_" + f.kernel) ||
          words.contains(library.name + "_gpu_" + f.kernel))
          << f.kernel << " of " << library.name;
  }
}

TEST_P(Languages, PrintFilesOfTheirOwn) {
  for (const Library& library : test::samples()) {
    std::set<std::filesystem::path> paths;
    const std::vector<OutputFile> files = print(library);
    EXPECT_FALSE(files.empty());
    for (const OutputFile& file : files) {
      EXPECT_TRUE(paths.insert(file.path).second) << file.path << " is made twice";
      EXPECT_TRUE(file.path.is_relative() && file.path == file.path.lexically_normal()) << file.path;
      EXPECT_NE(*file.path.begin(), "..");
      EXPECT_TRUE(file.text.ends_with('\n')) << file.path;
    }
  }
}

TEST_P(Languages, PrintTheSameTwice) {
  for (const Library& library : test::samples()) {
    const std::vector<OutputFile> once = print(library), twice = print(library);
    ASSERT_EQ(once.size(), twice.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
      EXPECT_EQ(once[i].path, twice[i].path);
      EXPECT_EQ(once[i].text, twice[i].text);
    }
  }
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const Language& language : languages()) result.push_back(language.name);
  return result;
}
INSTANTIATE_TEST_SUITE_P(All, Languages, testing::ValuesIn(names()), [](const auto& language) {
  return language.param;
});

TEST(LanguageTable, HasCppFirstAndNamesOnce) {
  const std::vector<std::string> all = names();
  EXPECT_EQ(all.front(), "cpp");
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
}

}  // namespace
}  // namespace robcogen::backend::languages_test
