// Where pieces of a text end. In each text, a bar marks the end of the piece at its beginning.
#include "language/common/text_pieces.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace robcogen::language::text_pieces_test {
namespace {

// The text without its bar, and the bar's position: npos if there is none.
struct Marked {
  explicit Marked(std::string marked) : text(std::move(marked)), bar(text.find('|')) {
    if (bar != std::string::npos) text.erase(bar, 1);
  }

  std::string text;
  std::size_t bar;
};

TEST(TextPieces, CharactersBehindTheEndAreZero) {
  EXPECT_EQ(character("ab", 1), 'b');
  EXPECT_EQ(character("ab", 2), '\0');
  EXPECT_EQ(character("ab", std::string_view::npos), '\0');
}

TEST(TextPieces, LinesEndBeforeAnyLineBreak) {
  for (const char* marked : {"a b|\nc", "a|\r\nb", "a|\rb", "|\n", "ab|"}) {
    const Marked line(marked);
    EXPECT_EQ(end_of_line(line.text, 0), line.bar) << marked;
  }
}

TEST(TextPieces, WordsEndBehindLettersAndDigits) {
  for (const char* marked : {"a_1| b", "1a|.b", "|.a", "abc|"}) {
    const Marked word(marked);
    EXPECT_EQ(end_of_word(word.text, 0), word.bar) << marked;
  }
}

TEST(TextPieces, CommentsEndWithTheirLineOrSign) {
  for (const char* marked : {"// a|\nb", "// a|", "/* a\nb */| c", "/*/ */|", "/**/|*/", "/*/", "/* a *"}) {
    const Marked comment(marked);
    EXPECT_TRUE(begins_comment(comment.text, 0)) << marked;
    EXPECT_EQ(end_of_comment(comment.text, 0), comment.bar) << marked;
  }
  EXPECT_FALSE(begins_comment("/ /", 0));
  EXPECT_FALSE(begins_comment("/", 0));
}

TEST(TextPieces, QuotedTextEndsInItsLine) {
  for (const char* marked : {"\"a b\"| c", "\"\"|", "\"a\nb\"", "\"a\rb\"", "\"a", "a\"b\"", ""}) {
    const Marked quoted(marked);
    EXPECT_EQ(end_of_quoted(quoted.text, 0), quoted.bar) << marked;
  }
}

TEST(TextPieces, NumbersEndBehindTheirExponent) {
  for (const char* marked :
       {"1| 2", "1.5|", ".5|+1", "1.|)", "1e5|", "1.0E+2|*a", "2.5e-3|-1", "2.0|a", "2.0e5|x", "1.0|ex", "1|+e5"}) {
    const Marked number(marked);
    const NumberText found = number_text(number.text, 0);
    EXPECT_EQ(found.end, number.bar) << marked;
    EXPECT_FALSE(found.is_malformed) << marked;
  }
}

TEST(TextPieces, MalformedNumbersEndBehindAllThatLooksLikeANumber) {
  for (const char* marked : {"1.2.3| a", "1..2|", "0x1F| 2", "1_000|*a", "1e5e2|+1", "1e|)", "2.0E+|", "1d0|,"}) {
    const Marked number(marked);
    const NumberText found = number_text(number.text, 0);
    EXPECT_EQ(found.end, number.bar) << marked;
    EXPECT_TRUE(found.is_malformed) << marked;
  }
  EXPECT_EQ(number_text("1e5e2", 0).hint, "write one exponent");
  EXPECT_EQ(number_text("1.2.3", 0).hint, "");
}

TEST(TextPieces, RunsOfStrayBytesEndBeforeTokens) {
  for (const char* marked : {";;#| a", "$|${a}", "\xff\xfe|\n", "^|^a", "?|{", "%%|"}) {
    const Marked run(marked);
    EXPECT_EQ(end_of_stray_run(run.text, 0), run.bar) << marked;
  }
}

}  // namespace
}  // namespace robcogen::language::text_pieces_test
