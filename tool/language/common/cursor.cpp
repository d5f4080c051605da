#include "language/common/cursor.h"

#include <fmt/format.h>

#include <algorithm>

namespace robcogen::language {
namespace {

// The words between quotes: `'Robot' or 'Model'` names two.
std::vector<std::string> quoted_words(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t begin = text.find('\''); begin != std::string_view::npos;) {
    const std::size_t end = text.find('\'', begin + 1);
    if (end == std::string_view::npos) break;
    words.emplace_back(text.substr(begin + 1, end - begin - 1));
    begin = text.find('\'', end + 1);
  }
  return words;
}

}  // namespace

std::string describe(const Token& token) {
  switch (token.kind) {
    case Token::Kind::end:
      return "the end of the file";
    case Token::Kind::number:
      return "number " + quote(token.text);
    case Token::Kind::identifier:
    case Token::Kind::symbol:
      break;
  }
  return quote(token.text);
}

Cursor::Cursor(TokenList list, std::vector<std::string> keywords, Diagnostics& diagnostics)
    : list_(std::move(list)), keywords_(std::move(keywords)), diagnostics_(diagnostics) {
  std::sort(keywords_.begin(), keywords_.end());
}

const Token& Cursor::peek(std::size_t ahead) const {
  return list_.tokens[std::min(at_ + ahead, list_.tokens.size() - 1)];
}

Token Cursor::take() {
  if (at("{")) open_braces_.push_back(peek().span);
  if (at("}") && !open_braces_.empty()) open_braces_.pop_back();
  const Token& token = peek();
  if (at_ + 1 < list_.tokens.size()) ++at_;
  return token;
}

bool Cursor::at(std::string_view word, std::size_t ahead) const {
  const Token& token = peek(ahead);
  const bool is_word = token.kind == Token::Kind::symbol || token.kind == Token::Kind::identifier;
  return is_word && !token.escaped && token.text == word;
}

bool Cursor::at_any(std::initializer_list<std::string_view> words) const {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return at(word); });
}

bool Cursor::begins_line() const {
  const std::string_view before = list_.source->text().substr(0, peek().span.begin);
  const std::size_t last = before.find_last_not_of(" \t");
  return last == std::string_view::npos || before[last] == '\n' || before[last] == '\r';
}

bool Cursor::at_name(std::size_t ahead) const {
  return peek(ahead).kind == Token::Kind::identifier && !is_keyword(peek(ahead));
}

bool Cursor::accept(std::string_view word) {
  if (!at(word)) return false;
  take();
  return true;
}

Token Cursor::expect(std::string_view word, std::string_view context) {
  if (!at(word)) unexpected(fmt::format("'{}'", word), context);
  return take();
}

Token Cursor::expect_name(std::string_view what) {
  if (at_name()) return take();
  if (!at_keyword()) unexpected(what, "");
  error("keyword-as-name", fmt::format("'{}' is a keyword and cannot be {}", peek().text, what)).hint =
      fmt::format("write '^{}' to use it as a name", peek().text);
  throw SyntaxError{};
}

Diagnostic& Cursor::error(std::string code, std::string message) {
  return error_at(peek().span, std::move(code), std::move(message));
}

Diagnostic& Cursor::error_at(Span span, std::string code, std::string message) {
  return diagnostics_.error(std::move(code), place(span), std::move(message));
}

Diagnostic& Cursor::warning_at(Span span, std::string code, std::string message) {
  return diagnostics_.warning(std::move(code), place(span), std::move(message));
}

void Cursor::unexpected(std::string_view expected, std::string_view context) {
  if (at_end()) {
    if (!list_.cut) report_unexpected_end(expected);
    throw SyntaxError{};
  }
  Diagnostic& d = error(
      "unexpected-token",
      fmt::format(
          "expected {}{}, found {}", expected, context.empty() ? "" : fmt::format(" {}", context), describe(peek())));
  if (peek().kind == Token::Kind::identifier) d.hint = did_you_mean(std::string(peek().text), quoted_words(expected));
  throw SyntaxError{};
}

void Cursor::report_unexpected_end(std::string_view expected) {
  if (at_ == 0) {
    error("empty-document", fmt::format("the document is empty, expected {}", expected));
    return;
  }
  Diagnostic& d = error("unexpected-end", fmt::format("the file ends where {} is expected", expected));
  if (!open_braces_.empty()) d.notes.push_back({place(open_braces_.back()), "this '{' is still open"});
}

std::vector<std::string> Cursor::comments_before(std::size_t offset) {
  std::vector<std::string> found;
  for (; next_comment_ < list_.comments.size() && list_.comments[next_comment_].span.begin < offset; ++next_comment_)
    found.push_back(list_.comments[next_comment_].text);
  return found;
}

bool Cursor::is_keyword(const Token& token) const {
  return token.kind == Token::Kind::identifier && !token.escaped &&
         std::binary_search(keywords_.begin(), keywords_.end(), token.text);
}

}  // namespace robcogen::language
