// Converts source text to tokens, for all four languages.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "support/diagnostics.h"
#include "support/number.h"

namespace robcogen::language {

struct Token {
  enum class Kind { identifier, number, symbol, string, end };
  Kind kind = Kind::end;
  bool escaped = false;   // identifier written with '^': never a keyword
  std::string_view text;  // in the source: identifier without its escape, number as written, symbol (`->` is one),
                          // string without its quotes
  Span span;
};

struct Comment {
  std::string text;  // with its delimiters, without trailing blanks
  Span span;
};

struct TokenList {
  std::shared_ptr<const Source> source;
  std::vector<Token> tokens;  // the last one is `end`
  std::vector<Comment> comments;
  std::vector<Span> faults;  // text that the lexer reported, in order
  bool cut = false;  // the tokens end before the text does, which has been reported: do not report missing tokens
};

// Splits the text into tokens. Reports bytes that belong to no token (a character once per line), malformed numbers
// (`0x1F`, `1_000`, `1e`, `1d0`, `1.0f`, `O.5`), quotes around a token except after the word `import`, and names that
// are too long; continues after each. Text that makes the rest meaningless (an unterminated comment, a `${…}` of a
// template, UTF-16) is reported and ends the list.
TokenList tokenize(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// Returns the value of a number; zero for a number that was reported.
Number number_of(const Token& token);

// Returns the text in quotes, shortened if it is too long for a message.
std::string quote(std::string_view text);

}  // namespace robcogen::language
