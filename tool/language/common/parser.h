// What the recursive-descent parsers of all languages share: a cursor over tokens, expectations, expressions.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "language/common/expression.h"
#include "language/common/lexer.h"

namespace robcogen::language {

// Thrown inside a parser where a construct cannot go on; caught where the parser can resynchronise. The diagnostic has
// been reported.
struct SyntaxError {};

class Cursor {
 public:
  // Keywords are reserved: unless escaped they are never taken as names or operands.
  Cursor(TokenList list, std::vector<std::string> keywords, Diagnostics& diagnostics);

  const Token& peek(std::size_t ahead = 0) const;
  Token take();
  bool at_end() const { return peek().kind == Token::Kind::end; }
  bool at(std::string_view symbol_or_keyword, std::size_t ahead = 0) const;
  bool at_any(std::initializer_list<std::string_view> words) const;
  bool at_keyword() const { return is_keyword(peek()); }
  bool at_name() const { return peek().kind == Token::Kind::identifier && !is_keyword(peek()); }
  bool accept(std::string_view symbol_or_keyword);
  Token expect(std::string_view symbol_or_keyword, std::string_view context);
  // An identifier that is no keyword.
  Token expect_name(std::string_view what);

  // Reports at the present token (or at the given span).
  Diagnostic& error(std::string code, std::string message);
  Diagnostic& error_at(Span span, std::string code, std::string message);
  Place place(Span span) const { return {list_.source, span}; }
  [[noreturn]] void unexpected(std::string_view expected, std::string_view context);

  // Skips to just before a `}` that closes the block we are in, or one of these keywords, stepping over nested blocks.
  void skip_to(std::initializer_list<std::string_view> words);

  ExpressionPtr expression();

  // Comments that stand before this offset and were not handed out yet.
  std::vector<std::string> comments_before(std::size_t offset);

 private:
  TokenList list_;
  std::vector<std::string> keywords_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  std::size_t next_comment_ = 0;
  int depth_ = 0;

  // One more level of nesting while it lives; a SyntaxError where that is too much.
  class Nesting {
   public:
    Nesting(Cursor& cursor, Span span);
    ~Nesting() { --cursor_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    Cursor& cursor_;
  };

  bool is_keyword(const Token& token) const;
  bool at_juxtaposed_operand(const Expression& left, std::size_t left_end) const;
  void limit(int operations);
  ExpressionPtr sum();
  ExpressionPtr product();
  ExpressionPtr unary();
  ExpressionPtr primary();
  ExpressionPtr name_or_function();
  ExpressionPtr named_constant();
};

// How a token reads in a message: `'}'`, `number '0.5'`, `end of file`.
std::string describe(const Token& token);

}  // namespace robcogen::language
