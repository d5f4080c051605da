// Patterns of names.
#include "support/wildcards.h"

#include <gtest/gtest.h>

#include <functional>

namespace robcogen::wildcards_test {
namespace {

TEST(Wildcards, MatchWholeTexts) {
  for (const char* pattern :
       {"*", "LF_foot", "LF_*", "*_foot", "*F*t", "L*_f*", "LF?foot", "??_*", "**foot**", "LF_foo?"})
    EXPECT_TRUE(matches(pattern, "LF_foot")) << pattern;
  for (const char* pattern :
       {"", "?", "LF", "foot", "LF_", "_foot", "*_foo", "F_*", "LF_foot?", "LF__*", "*hand*", "lf_*"})
    EXPECT_FALSE(matches(pattern, "LF_foot")) << pattern;
  EXPECT_TRUE(matches("", ""));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_FALSE(matches("?", ""));
}

// Every pattern and text of up to four characters, against the definition.
TEST(Wildcards, MatchByTheirDefinition) {
  const std::function<bool(std::string_view, std::string_view)> defined = [&](std::string_view p, std::string_view t) {
    if (p.empty()) return t.empty();
    if (p[0] == '*') return defined(p.substr(1), t) || (!t.empty() && defined(p, t.substr(1)));
    return !t.empty() && (p[0] == '?' || p[0] == t[0]) && defined(p.substr(1), t.substr(1));
  };
  const auto words = [](const std::string& letters) {
    std::vector<std::string> all = {""};
    for (std::size_t k = 0; all[k].size() < 4; ++k)
      for (const char c : letters) all.push_back(all[k] + c);
    return all;
  };
  for (const std::string& pattern : words("ab*?"))
    for (const std::string& text : words("ab"))
      ASSERT_EQ(matches(pattern, text), defined(pattern, text)) << pattern << ' ' << text;
}

TEST(Wildcards, GuessesWhatAPatternShouldMatch) {
  const std::vector<std::string> names = {"trunk", "LF_hip", "LF_foot", "RF_foot"};
  EXPECT_EQ(nearest_to_pattern("*_foo_t", names), "LF_foot");
  EXPECT_EQ(nearest_to_pattern("RF_fot*", names), "RF_foot");
  EXPECT_EQ(nearest_to_pattern("*_fooot", names), "LF_foot");
  EXPECT_EQ(nearest_to_pattern("*_hand", names), "");
  EXPECT_EQ(nearest_to_pattern("*", names), "");
  EXPECT_EQ(nearest_to_pattern("*x", names), "");
}

}  // namespace
}  // namespace robcogen::wildcards_test
