// Source text to tokens, for all four languages.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/diagnostics.h"
#include "support/number.h"

namespace robcogen::language {

struct Token {
  enum class Kind { identifier, number, symbol, end };
  Kind kind = Kind::end;
  std::string text;      // identifier without its escape, number as written, one symbol (`->` and `<-` are one)
  bool escaped = false;  // identifier written with '^': never a keyword
  Number number;
  Span span;
};

struct Comment {
  std::string text;  // with its delimiters
  Span span;
};

struct TokenList {
  std::shared_ptr<const Source> source;
  std::vector<Token> tokens;  // the last one is `end`
  std::vector<Comment> comments;
};

// Reports bytes that belong to no token, numbers that are none, and comments that do not end; goes on after each.
TokenList tokenize(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

}  // namespace robcogen::language
