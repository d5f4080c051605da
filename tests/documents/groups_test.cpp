// The generator defines the list of function groups; CMake and the guides repeat it.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "markdown.h"

namespace robcogen::test {
namespace {

using Words = std::vector<std::string>;

Words split(const std::string& text, char separator) {
  Words words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);)
    if (const std::size_t first = word.find_first_not_of(' '); first != std::string::npos)
      words.push_back(word.substr(first));
  return words;
}

// The groups that the help of `robcogen generate` lists for --algorithms.
struct Groups {
  Words all, by_default;
};

Groups groups_of_tool() {
  int status = 0;
  const std::string help = output_of("'" ROBCOGEN_TOOL "' generate --help", status);
  std::smatch all;
  const std::regex pattern(R"(--algorithms TEXT:\{([^}]*)\}[^-]* default ([a-z_, ]*))");
  const bool found = std::regex_search(help, all, pattern);
  EXPECT_TRUE(found && status == 0) << help;
  Groups groups;
  if (!found) return groups;
  groups = {split(all[1], ','), split(all[2], ',')};
  EXPECT_EQ(groups.all.back(), "all");
  groups.all.pop_back();
  return groups;
}

TEST(Groups, OfCMakeAreThoseOfTheGenerator) {
  const Groups groups = groups_of_tool();
  EXPECT_EQ(split(ROBCOGEN_GROUPS, ','), groups.all);
  EXPECT_EQ(split(ROBCOGEN_DEFAULT_GROUPS, ','), groups.by_default);
}

// The rows | `group` | yes or no | functions | of cmake/README.md are the lines of the generator's list.
TEST(Groups, OfTheGuideAreThoseOfTheGenerator) {
  std::vector<Words> listed, shown;
  const std::regex line(R"re(ROBCOGEN_GROUP\((\w+), (true|false), [\w |]+, "(.*)"\))re");
  for (const std::string& text : split(read_text(source_folder() / "tool/algorithm/catalogue/groups.inc"), '\n'))
    if (std::smatch found; std::regex_match(text, found, line))
      listed.push_back({"`" + found[1].str() + "`", found[2] == "true" ? "yes" : "no", found[3]});
  for (const Words& row : table_rows(read_text(source_folder() / "cmake/README.md")))
    if (row.size() == 3 && (row[1] == "yes" || row[1] == "no")) shown.push_back(row);
  EXPECT_EQ(shown, listed);
  EXPECT_EQ(listed.size(), groups_of_tool().all.size());
}

// The rows | `KEYWORD`, `KEYWORD` | meaning | of cmake/README.md list every keyword of the two functions.
TEST(Groups, KeywordsOfTheGuideAreThoseOfTheFunctions) {
  const auto words_of = [](const std::string& text) {
    Words words;
    const std::regex word("[A-Z][A-Z_]+");
    for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at) words.push_back(at->str());
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
  };
  const auto section = [](const std::string& guide, const std::string& title) {
    const std::size_t begin = guide.find("\n## " + title + "\n");
    return guide.substr(begin, guide.find("\n## ", begin + 1) - begin);
  };
  const std::string guide = read_text(source_folder() / "cmake/README.md");
  for (const auto& [function, file] :
       {std::pair("robcogen_add_robot", "Robcogen.cmake"),
        std::pair("robcogen_add_transforms", "RobcogenTransforms.cmake")}) {
    std::string declared, shown;
    for (const std::string& line : split(read_text(source_folder() / "cmake" / file), '\n'))
      if (std::regex_search(line, std::regex(R"(^set\((flags|values|lists) [A-Z])"))) declared += line + "\n";
    for (const Words& row : table_rows(section(guide, function)))
      if (row[0].starts_with("`") && row[0][1] >= 'A' && row[0][1] <= 'Z') shown += row[0] + "\n";
    EXPECT_EQ(words_of(shown), words_of(declared)) << function;
    EXPECT_GE(words_of(declared).size(), 10) << function;
  }
}

}  // namespace
}  // namespace robcogen::test
