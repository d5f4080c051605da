// What the recursive-descent parsers of all languages share: a cursor over tokens, expectations, recovery.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "language/common/lexer.h"

namespace robcogen::language {

// Thrown inside a parser where a construct cannot go on; caught where the parser can resynchronise. The diagnostic has
// been reported.
struct SyntaxError {};

// Thrown where the document turns out to be in another language as a whole. The diagnostic has been reported.
struct OtherLanguage {};

class Cursor {
 public:
  // Keywords are reserved: unless escaped they are never taken as names or operands.
  Cursor(TokenList list, std::vector<std::string> keywords, Diagnostics& diagnostics);

  const Token& peek(std::size_t ahead = 0) const;
  Token take();
  const Token& previous() const { return list_.tokens[at_ - 1]; }  // the token taken last
  bool at_end() const { return peek().kind == Token::Kind::end; }
  bool at(std::string_view symbol_or_keyword, std::size_t ahead = 0) const;
  bool at_any(std::initializer_list<std::string_view> words) const;
  bool at_keyword() const { return is_keyword(peek()); }
  // Nothing but blanks stands before the present token in its line.
  bool begins_line() const;
  // At an identifier that is no keyword.
  bool at_name(std::size_t ahead = 0) const;
  bool accept(std::string_view symbol_or_keyword);
  Token expect(std::string_view symbol_or_keyword, std::string_view context);
  Token expect_name(std::string_view what);

  Place place(Span span) const { return {list_.source, span}; }
  // Report at the present token, or at the given span.
  Diagnostic& error(std::string code, std::string message);
  Diagnostic& error_at(Span span, std::string code, std::string message);
  Diagnostic& warning_at(Span span, std::string code, std::string message);
  // `expected …, found …`, with a hint when a quoted word of `expected` may have been meant. No further error at the
  // end of tokens that were cut short.
  [[noreturn]] void unexpected(std::string_view expected, std::string_view context);

  // How many blocks are open here: `{` taken and its `}` not yet.
  std::size_t open_blocks() const { return open_braces_.size(); }
  // As if a `{` that is missing here, which has been reported, had been taken.
  void assume_open_brace() { open_braces_.push_back(peek().span); }
  template <class Predicate>
  void skip_until(Predicate stop) {
    while (!at_end() && !stop()) take();
  }

  // Comments that stand before this offset and were not handed out yet.
  std::vector<std::string> comments_before(std::size_t offset);

 private:
  TokenList list_;
  std::vector<std::string> keywords_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  std::size_t next_comment_ = 0;
  std::vector<Span> open_braces_;

  bool is_keyword(const Token& token) const;
  void report_unexpected_end(std::string_view expected);
};

// How a token reads in a message: `'}'`, `number '0.5'`, `the end of the file`.
std::string describe(const Token& token);

}  // namespace robcogen::language
