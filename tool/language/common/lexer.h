// Source text to tokens, for all four languages.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "support/diagnostics.h"
#include "support/number.h"

namespace robcogen::language {

struct Token {
  enum class Kind { identifier, number, symbol, end };
  Kind kind = Kind::end;
  bool escaped = false;   // identifier written with '^': never a keyword
  std::string_view text;  // in the source: identifier without its escape, number as written, symbol (`->` is one)
  Span span;
};

struct Comment {
  std::string text;  // with its delimiters, without blanks at its end
  Span span;
};

struct TokenList {
  std::shared_ptr<const Source> source;
  std::vector<Token> tokens;  // the last one is `end`
  std::vector<Comment> comments;
  bool cut = false;  // the tokens end before the text does, which has been reported: nothing that is missing is news
};

// Reports bytes that belong to no token, malformed numbers (`0x1F`, `1_000`, `1e`, `1d0`, `1.0f`), and names without
// end; goes on after each. What makes
// the rest of the text meaningless (a comment that does not end, a `${…}` of a template, UTF-16) is reported and ends
// the list.
TokenList tokenize(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// The value of a number; zero for one that was reported.
Number number_of(const Token& token);

// The text between quotes, cut where it is too long for a message.
std::string quote(std::string_view text);

}  // namespace robcogen::language
