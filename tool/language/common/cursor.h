// A cursor over tokens with expectations and error recovery, shared by the recursive-descent parsers of all languages.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "language/common/lexer.h"

namespace robcogen::language {

// Thrown inside a parser if a construct cannot continue; caught where the parser can resynchronise. The diagnostic has
// been reported.
struct SyntaxError {};

// Thrown if the document turns out to be in another language. The diagnostic has been reported.
struct OtherLanguage {};

class Cursor {
 public:
  // Keywords are reserved: unless escaped, they are never taken as names or operands.
  Cursor(TokenList list, std::vector<std::string> keywords, Diagnostics& diagnostics);

  const Token& peek(std::size_t ahead = 0) const;
  Token take();
  const Token& previous() const { return list_.tokens[at_ - 1]; }  // the token taken last
  bool at_begin() const { return at_ == 0; }
  bool at_end() const { return peek().kind == Token::Kind::end; }
  bool at(std::string_view symbol_or_keyword, std::size_t ahead = 0) const;
  bool at_any(std::initializer_list<std::string_view> words) const;
  bool at_keyword() const { return is_keyword(peek()); }
  // Whether only blanks precede the present token in its line.
  bool begins_line() const;
  // Whether the present token is on a later line than the token before it.
  bool after_line_end() const;
  // Whether the two tokens from here are on one line, with no blank in between.
  bool adjacent(std::size_t ahead = 0) const;
  // Whether the cursor is at an identifier that is not a keyword.
  bool at_name(std::size_t ahead = 0) const;
  bool accept(std::string_view symbol_or_keyword);
  // `hint` is for a word that is not similar to the expected one.
  Token expect(std::string_view symbol_or_keyword, std::string_view context, const std::string& hint = "");
  Token expect_name(std::string_view what);

  Place place(Span span) const { return {list_.source, span}; }
  // Report at the present token, or at the given span.
  Diagnostic& error(std::string code, std::string message);
  Diagnostic& error_at(Span span, std::string code, std::string message);
  Diagnostic& warning_at(Span span, std::string code, std::string message);
  // Reports `expected …, found …`, with a hint if a quoted word of `expected` may be intended. Reports nothing if the
  // lexer has reported the text nearby, or at the end of tokens that were cut short.
  [[noreturn]] void unexpected(std::string_view expected, std::string_view context, const std::string& hint = "");
  // Whether the lexer has reported text on this line, or between the present token and the token before it.
  bool is_faulty_here() const;

  // Marks the beginning of a statement. Within a statement, a token that is missing at the end of a line is reported
  // there, and not at the first token of the next line.
  void begin_statement() { statement_ = at_; }

  // Whether the cursor is at a decimal comma, as in `1,5`, after the number that was taken last.
  bool at_decimal_comma() const;
  [[noreturn]] void decimal_comma(Span span);

  // The number of blocks that are open here: `{` was taken, but not its `}`.
  std::size_t open_blocks() const { return open_braces_.size(); }
  // Continues as if a missing brace had been taken. The missing brace has been reported.
  void assume_open_brace() { open_braces_.push_back(peek().span); }
  void assume_closing_brace() {
    if (!open_braces_.empty()) open_braces_.pop_back();
  }
  template <class Predicate>
  void skip_until(Predicate stop) {
    while (!at_end() && !stop()) take();
  }

  // Returns the comments before this offset that were not returned yet.
  std::vector<std::string> comments_before(std::size_t offset);

 private:
  TokenList list_;
  std::vector<std::string> keywords_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  std::size_t statement_ = 0;  // index of its first token
  std::size_t next_comment_ = 0;
  std::vector<Span> open_braces_;

  bool is_keyword(const Token& token) const;
  // Whether the cursor is inside a statement and after the last token of a line.
  bool misses_token() const { return at_ > statement_ && after_line_end(); }
  void report_unexpected_end(std::string_view expected);
  std::string hint_for(std::string_view expected) const;
};

// Returns a token as text for a message: `'}'`, `number '0.5'`, `the end of the file`.
std::string describe(const Token& token);

// Returns `did you mean 'x'?` for the keyword that is similar to the word or contains it, or an empty string.
std::string suggest_keyword(std::string_view word, const std::vector<std::string>& keywords);

}  // namespace robcogen::language
