#include "support/diagnostics.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace robcogen::diagnostics_test {
namespace {

std::shared_ptr<const Source> source(std::string text, std::string name = "arm.kindsl") {
  return std::make_shared<Source>(std::move(name), std::move(text));
}

// The place of the first occurrence of `word` in the text.
Place place(const std::shared_ptr<const Source>& text, const std::string& word) {
  const std::size_t begin = text->text().find(word);
  return {text, {begin, begin + word.size()}};
}

std::string error_at(const std::string& text, const std::string& word) {
  Diagnostics diagnostics;
  diagnostics.error("a-code", place(source(text), word), "a message");
  return diagnostics.render();
}

TEST(Diagnostics, ShowPlaceLineCaretsNotesAndHint) {
  const auto text = source("one\n  upper via elbow\n  lower via elbow\n");
  Diagnostics diagnostics;
  const std::size_t second = text->text().rfind("elbow");
  Diagnostic& error =
      diagnostics.error("joint-used-twice", {text, {second, second + 5}}, "joint 'elbow' is used twice");
  error.notes.push_back({place(text, "elbow"), "first used here"});
  error.hint = "did you mean 'elbows'?";
  const std::string expected =
      "arm.kindsl:3:13: error: joint 'elbow' is used twice [joint-used-twice]\n"
      "      lower via elbow\n"
      "                ^~~~~\n"
      "arm.kindsl:2:13: note: first used here\n"
      "      upper via elbow\n"
      "                ^~~~~\n"
      "hint: did you mean 'elbows'?\n";
  EXPECT_EQ(diagnostics.render(), expected);
  EXPECT_EQ(render(diagnostics.all().front()), expected);
}

TEST(Diagnostics, SpeakTheFormatOfVisualStudioToo) {
  const auto text = source("a b\n");
  Diagnostics diagnostics;
  diagnostics.warning("a-code", place(text, "b"), "a message").notes.push_back({place(text, "a"), "a note"});
  EXPECT_EQ(
      diagnostics.render({ErrorFormat::msvc}),
      "arm.kindsl(1,3): warning a-code: a message\n    a b\n      ^\n"
      "arm.kindsl(1,1): note: a note\n    a b\n    ^\n");
}

TEST(Diagnostics, MayHaveNoPlace) {
  Diagnostics diagnostics;
  diagnostics.error("a-code", {}, "a message");
  EXPECT_EQ(diagnostics.render(), "robcogen: error: a message [a-code]\n");
}

TEST(Diagnostics, KeepCaretsUnderTabs) {
  EXPECT_EQ(
      error_at("\tx\there\n", "here"), "arm.kindsl:1:4: error: a message [a-code]\n    \tx\there\n    \t \t^~~~\n");
}

TEST(Diagnostics, KeepCaretsUnderCharactersOfSeveralBytes) {
  EXPECT_EQ(
      error_at("/* ä€😀 */ here\n", "here"),
      "arm.kindsl:1:17: error: a message [a-code]\n    /* ä€😀 */ here\n              ^~~~\n");
  EXPECT_EQ(error_at("x äö y\n", "äö"), "arm.kindsl:1:3: error: a message [a-code]\n    x äö y\n      ^~\n");
}

TEST(Diagnostics, ShowControlCharactersAsBlanksAndBrokenTextAsQuestionMarks) {
  EXPECT_EQ(
      error_at(std::string("a\0\x1b[2J\x7f\xc2\x9b here", 14), "here"),
      "arm.kindsl:1:11: error: a message [a-code]\n    a  [2J   here\n             ^~~~\n");
  EXPECT_EQ(
      error_at("\xff\x80\xc3 \xf0\x9f\x98 here", "here"),
      "arm.kindsl:1:9: error: a message [a-code]\n    ??? ??? here\n            ^~~~\n");
}

TEST(Diagnostics, PointBehindTheLastCharacter) {
  const auto text = source("ab\n");
  Diagnostics diagnostics;
  diagnostics.error("a-code", {text, {3, 3}}, "the end");
  diagnostics.error("a-code", {text, {0, 3}}, "over the line end");
  EXPECT_EQ(
      diagnostics.render(),
      "arm.kindsl:1:1: error: over the line end [a-code]\n    ab\n    ^~\n"
      "arm.kindsl:2:1: error: the end [a-code]\n    \n    ^\n");
}

// The two lines of the excerpt, without their indentation.
std::pair<std::string, std::string> excerpt(const std::string& rendered) {
  const std::size_t first = rendered.find('\n') + 5, second = rendered.find('\n', first) + 5;
  return {rendered.substr(first, second - 5 - first), rendered.substr(second, rendered.find('\n', second) - second)};
}

std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

TEST(Diagnostics, ShowAWindowOfALongLine) {
  const std::string filler(5'000'000, 'x');
  const auto [line, carets] = excerpt(error_at(filler + " here " + filler, "here"));
  EXPECT_LE(columns(line), 162u);
  EXPECT_TRUE(line.starts_with("…x") && line.ends_with("x…")) << line;
  // "…" is one column and three bytes
  EXPECT_EQ(line.substr(carets.find('^') + 2, 4), "here");
  EXPECT_EQ(carets.find_last_of('~') - carets.find('^'), 3u);

  const auto [beginning, first] = excerpt(error_at("here " + filler, "here"));
  EXPECT_TRUE(beginning.starts_with("here x") && beginning.ends_with("x…"));
  EXPECT_EQ(first, "^~~~");
  const auto [end, last] = excerpt(error_at(filler + " here", "here"));
  EXPECT_TRUE(end.ends_with(" here"));
  EXPECT_EQ(last.size(), columns(end));
}

TEST(Diagnostics, NeverSplitACharacter) {
  std::string filler;
  for (int i = 0; i < 1000; ++i) filler += "€";
  for (const char* shift : {"", "x", "xx"}) {
    std::string text = shift;
    text.append(filler).append("here").append(filler);
    const auto [line, carets] = excerpt(error_at(text, "here"));
    EXPECT_EQ(line.find('?'), std::string::npos) << line;
    EXPECT_NE(line.find("here"), std::string::npos);
    EXPECT_EQ(columns(line.substr(0, line.find("here"))), carets.find('^'));
  }
}

TEST(Diagnostics, AreSortedBySourceAndPlace) {
  const auto first = source("a b c", "first"), second = source("a b c", "second");
  Diagnostics diagnostics;
  diagnostics.error("x", place(first, "c"), "3");
  diagnostics.error("x", place(second, "a"), "4");
  diagnostics.warning("x", place(first, "a"), "1");
  diagnostics.error("x", place(first, "b"), "2");
  const std::string text = diagnostics.render();
  EXPECT_LT(text.find(": 1"), text.find(": 2"));
  EXPECT_LT(text.find(": 2"), text.find(": 3"));
  EXPECT_LT(text.find(": 3"), text.find(": 4"));
}

TEST(Diagnostics, ShowSoManyErrorsAndCountTheRest) {
  const auto text = source("abcdef");
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < 3; ++i) diagnostics.warning("w", {text, {i, i + 1}}, "warning " + std::to_string(i));
  for (std::size_t i = 0; i < 4; ++i) diagnostics.error("e", {text, {i, i + 1}}, "error " + std::to_string(i));
  const std::string shown = diagnostics.render({.max_errors = 2});
  // warnings do not hide errors
  EXPECT_NE(shown.find("error 1"), std::string::npos);
  EXPECT_EQ(shown.find("error 2"), std::string::npos);
  EXPECT_TRUE(shown.ends_with("… and 2 more errors\n… and 1 more warnings\n")) << shown;
}

TEST(Diagnostics, FoldRepeatedNotes) {
  const auto robot = source("a\nb\nc\nd", "robot"), other = source("a", "other");
  Diagnostics diagnostics;
  for (const char* name : {"a", "b", "d"}) diagnostics.note("snapped", place(robot, name), name);
  diagnostics.note("snapped", place(other, "a"), "elsewhere");
  diagnostics.warning("snapped", place(robot, "c"), "a warning");
  EXPECT_EQ(
      diagnostics.render(),
      "robot:1:1: note: a [snapped]\n    a\n    ^\n… and 2 more notes [snapped], lines 2, 4; --verbose shows all\n"
      "robot:3:1: warning: a warning [snapped]\n    c\n    ^\nother:1:1: note: elsewhere [snapped]\n    a\n    ^\n");
  diagnostics.summarise_notes("snapped", "3 of them");
  const std::string summarised = diagnostics.render();
  EXPECT_TRUE(summarised.starts_with("robot:1:1: note: 3 of them [snapped]\nrobot:3:1: warning")) << summarised;
  const std::string all = diagnostics.render({.folds_notes = false});
  for (const char* line : {"robot:1:1: note: a ", "robot:2:1: note: b ", "robot:4:1: note: d ", "other:1:1"})
    EXPECT_NE(all.find(line), std::string::npos) << all;
}

TEST(Diagnostics, AreBoundedInNumber) {
  Diagnostics diagnostics;
  for (int i = 0; i < 25'000; ++i) diagnostics.error("e", {}, "garbage").notes.push_back({{}, "of many megabytes"});
  for (int i = 0; i < 12'000; ++i) diagnostics.warning("w", {}, "doubt");
  EXPECT_EQ(diagnostics.all().size(), 20'000u);
  EXPECT_EQ(diagnostics.error_count(), 25'000u);
  EXPECT_TRUE(diagnostics.render().ends_with("… and 24900 more errors\n… and 11900 more warnings\n"));
}

TEST(Diagnostics, CountErrorsAndNotWarnings) {
  Diagnostics diagnostics;
  diagnostics.warning("doubt", {}, "a warning");
  diagnostics.warning("fault", {}, "another");
  EXPECT_FALSE(diagnostics.has_errors());
  diagnostics.promote_warnings({"fault", "unheard-of"});
  EXPECT_EQ(diagnostics.error_count(), 1u);
  EXPECT_EQ(diagnostics.all()[0].severity, Severity::warning);
  diagnostics.error("e", {}, "an error");
  EXPECT_EQ(diagnostics.error_count(), 2u);
}

TEST(Nearest, FindsWhatWasMeant) {
  const std::vector<std::string> words = {"upperleg", "lowerleg", "link", "mass", "CoM", "Ix", "Iy", "translation"};
  EXPECT_EQ(nearest("uperleg", words), "upperleg");
  EXPECT_EQ(nearest("lowerlag", words), "lowerleg");
  EXPECT_EQ(nearest("lnik", words), "link");  // two exchanged neighbours are one typing error
  EXPECT_EQ(nearest("MASS", words), "mass");
  EXPECT_EQ(nearest("com", words), "CoM");
  EXPECT_EQ(nearest("trnslatoin", words), "translation");
  EXPECT_EQ(nearest("IX", words), "Ix");
  EXPECT_EQ(nearest("Ixx", {"Ixy", "Ix", "Ixz"}), "Ix");  // as URDF names it
  EXPECT_EQ(nearest("Iyx", {"Iy", "Ixy"}), "Ixy");
  EXPECT_EQ(nearest("tail", words), "");
  EXPECT_EQ(nearest("q", {"x", "xy"}), "");  // no letter would be left
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest("abc", {}), "");
  EXPECT_EQ(nearest(std::string(100'000, 'a'), {std::string(100'000, 'b')}), "");
  EXPECT_EQ(did_you_mean("uperleg", words), "did you mean 'upperleg'?");
  EXPECT_EQ(did_you_mean("tail", words), "");
}

}  // namespace
}  // namespace robcogen::diagnostics_test
