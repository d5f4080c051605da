#include "language/common/lexer.h"

#include "reading.h"

namespace robcogen::language::lexer_test {
namespace {

using std::string_literals::operator""s;
using test::Codes;

struct Lexed {
  std::string tokens;  // separated by '|'; an escaped name keeps its '^'
  std::vector<std::string> comments;
  Codes codes;
  bool cut = false;
};

Lexed lex(const std::string& text) {
  Diagnostics diagnostics;
  const TokenList list = tokenize(test::source(text), diagnostics);
  Lexed result;
  for (const Token& token : list.tokens) {
    if (token.kind == Token::Kind::end) continue;
    result.tokens +=
        (result.tokens.empty() ? "" : "|") + std::string(token.escaped ? "^" : "") + std::string(token.text);
  }
  EXPECT_EQ(list.tokens.back().kind, Token::Kind::end);
  for (const Comment& comment : list.comments) result.comments.push_back(comment.text);
  result.codes = test::codes(diagnostics);
  result.cut = list.cut;
  return result;
}

TEST(Lexer, KnowsNamesNumbersAndSymbols) {
  EXPECT_EQ(lex("link _a1 { id=3 }").tokens, "link|_a1|{|id|=|3|}");
  EXPECT_EQ(lex("A->B<-C -> D").tokens, "A|->|B|<-|C|->|D");
  EXPECT_EQ(lex("(a,-b)*[c]/<d>+e:f").tokens, "(|a|,|-|b|)|*|[|c|]|/|<|d|>|+|e|:|f");
  EXPECT_EQ(lex("^link ^ x").tokens, "^link|x");
  EXPECT_EQ(lex("").tokens, "");
}

TEST(Lexer, ReadsEverySpellingOfANumber) {
  EXPECT_EQ(lex("1.0 .5 1. 1 1e-3 1.0E5 1.e+2 007").tokens, "1.0|.5|1.|1|1e-3|1.0E5|1.e+2|007");
  EXPECT_EQ(lex("-1.0 +0.5").tokens, "-|1.0|+|0.5");
  EXPECT_EQ(lex("2.0a 2.0PI 2a 2.0e5x 1.0ex 1.0d 1.0f2").tokens, "2.0|a|2.0|PI|2|a|2.0e5|x|1.0|ex|1.0|d|1.0|f2");
  Diagnostics none;
  const TokenList list = tokenize(test::source("1.50e1"), none);
  EXPECT_EQ(number_of(list.tokens[0]).value(), 15.0);
}

TEST(Lexer, RefusesWhatLooksLikeANumber) {
  for (const char* text :
       {"0x1F", "0X1p3", "0b101", "1.2.3", "1..2", "1_000", "1.5_", "1e", "2.0E+", "1e-", "1e5e2", "1d0", "2.5D3",
        "1.0f", "1_000e+5", "0x1E+2"}) {
    EXPECT_EQ(lex(text).codes, Codes{"bad-number"}) << text;
    EXPECT_EQ(lex(text).tokens, text);  // the parser still gets one number
  }
  EXPECT_EQ(lex("1e999").codes, Codes{"number-too-large"});
  EXPECT_EQ(lex("1e-999").codes, Codes{});
}

TEST(Lexer, KeepsComments) {
  const Lexed lexed = lex("a // one  \r\nb /* two\n // three */ c /**/ d// four");
  EXPECT_EQ(lexed.tokens, "a|b|c|d");
  EXPECT_EQ(lexed.comments, (std::vector<std::string>{"// one", "/* two\n // three */", "/**/", "// four"}));
  EXPECT_EQ(lex("a // one\rb").tokens, "a|b") << "a lone carriage return ends a line";
  EXPECT_EQ(lex("a /* not /* nested */ b").tokens, "a|b");
  EXPECT_EQ(lex("/*/ a */ b").tokens, "b");
  EXPECT_EQ(lex("// \xff \xc3 ; # $ anything").codes, Codes{});
}

TEST(Lexer, SkipsAByteOrderMarkAtTheBeginningOnly) {
  EXPECT_EQ(lex("\xef\xbb\xbfRobot").tokens, "Robot");
  EXPECT_EQ(lex("\xef\xbb\xbfRobot").codes, Codes{});
  EXPECT_EQ(lex("Robot \xef\xbb\xbf x").codes, Codes{"stray-character"});
}

TEST(Lexer, ReportsARunOfStrayBytesOnce) {
  const Lexed lexed = lex("a \0\0\0 b ;;# c \xff\xfe\xfd$ d . ^"s);
  EXPECT_EQ(lexed.tokens, "a|b|c|d");
  EXPECT_EQ(lexed.codes, Codes(6, "stray-character"));
}

TEST(Lexer, EndsWhereTheRestMeansNothing) {
  EXPECT_EQ(lex("a /* b").codes, Codes{"unterminated-comment"});
  EXPECT_TRUE(lex("a /* b").cut);
  EXPECT_EQ(lex("a ${B} c ${D}").codes, Codes{"template"});
  EXPECT_EQ(lex("a ${B} c").tokens, "a");
  EXPECT_EQ(lex("${").codes, Codes{"template"});
  for (const std::string& text : {"\xff\xfeR\0o\0"s, "\xfe\xff\0R\0o"s, "R\0o\0b\0"s, "\0R\0o\0b"s}) {
    EXPECT_EQ(lex(text).codes, Codes{"not-utf-8"});
    EXPECT_TRUE(lex(text).cut);
  }
}

TEST(Lexer, CutsNamesWithoutEnd) {
  EXPECT_EQ(lex(std::string(255, 'x')).codes, Codes{});
  EXPECT_EQ(lex(std::string(256, 'x')).codes, Codes{"name-too-long"});
  EXPECT_EQ(lex(std::string(256, 'x')).tokens.size(), 255u);
}

}  // namespace
}  // namespace robcogen::language::lexer_test
