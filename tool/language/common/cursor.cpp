#include "language/common/cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace robcogen::language {
namespace {

// Returns the words between quotes: `'Robot' or 'Model'` contains two.
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

std::string suggest_keyword(std::string_view word, const std::vector<std::string>& keywords) {
  constexpr std::size_t kMinPart = 3;
  const std::string similar = did_you_mean(std::string(word), keywords);
  if (!similar.empty() || word.size() < kMinPart) return similar;
  const auto found =
      std::find_if(keywords.begin(), keywords.end(), [&](const auto& k) { return k.find(word) != std::string::npos; });
  return found == keywords.end() ? "" : fmt::format("did you mean '{}'?", *found);
}

std::string describe(const Token& token) {
  switch (token.kind) {
    case Token::Kind::end:
      return "the end of the file";
    case Token::Kind::number:
      return "number " + quote(token.text);
    case Token::Kind::identifier:
    case Token::Kind::symbol:
    case Token::Kind::string:
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

bool Cursor::after_line_end() const {
  if (at_ == 0) return false;
  const std::size_t end = previous().span.end;
  const std::string_view between = list_.source->text().substr(end, peek().span.begin - end);
  return between.find_first_of("\r\n") != std::string_view::npos;
}

bool Cursor::adjacent(std::size_t ahead) const {
  return peek(ahead + 1).kind != Token::Kind::end && peek(ahead).span.end == peek(ahead + 1).span.begin;
}

bool Cursor::is_faulty_here() const {
  constexpr std::size_t kMaxDistance = 1000;  // bounds the search: a line may be very long
  const auto after = std::lower_bound(
      list_.faults.begin(), list_.faults.end(), peek().span.begin + 1,
      [](const Span& fault, std::size_t offset) { return fault.begin < offset; });
  if (after == list_.faults.begin()) return false;
  const std::size_t end = std::prev(after)->end;
  if (end >= peek().span.begin || (at_ > 0 && end > previous().span.end)) return true;
  const std::size_t distance = peek().span.begin - end;
  return distance < kMaxDistance &&
         list_.source->text().substr(end, distance).find_first_of("\r\n") == std::string_view::npos;
}

bool Cursor::at_name(std::size_t ahead) const {
  return peek(ahead).kind == Token::Kind::identifier && !is_keyword(peek(ahead));
}

bool Cursor::accept(std::string_view word) {
  if (!at(word)) return false;
  take();
  return true;
}

Token Cursor::expect(std::string_view word, std::string_view context, const std::string& hint) {
  if (!at(word)) unexpected(fmt::format("'{}'", word), context, hint);
  return take();
}

Token Cursor::expect_name(std::string_view what) {
  if (at_name()) return take();
  if (peek().kind == Token::Kind::number && peek(1).kind == Token::Kind::identifier && adjacent()) {
    const Span word = {peek().span.begin, peek(1).span.end};
    const std::string_view text = list_.source->text().substr(word.begin, word.end - word.begin);
    error_at(word, "unexpected-token", fmt::format("expected {}, found '{}'", what, text)).hint =
        "a name begins with a letter or '_'";
    throw SyntaxError{};
  }
  if (!at_keyword() || misses_token()) unexpected(what, "");
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

void Cursor::unexpected(std::string_view expected, std::string_view context, const std::string& hint) {
  if (at_end()) {
    if (!list_.cut && !is_faulty_here()) report_unexpected_end(expected);
    throw SyntaxError{};
  }
  if (is_faulty_here()) throw SyntaxError{};
  const std::string missing = fmt::format("expected {}{}{}", expected, context.empty() ? "" : " ", context);
  if (misses_token()) {
    const std::size_t end = previous().span.end;
    error_at({end, end}, "unexpected-token", missing);
    throw SyntaxError{};
  }
  Diagnostic& d = error("unexpected-token", fmt::format("{}, found {}", missing, describe(peek())));
  d.hint = hint_for(expected);
  if (d.hint.empty()) d.hint = hint;
  throw SyntaxError{};
}

std::string Cursor::hint_for(std::string_view expected) const {
  const Token& token = peek();
  if (token.kind == Token::Kind::identifier) {
    const std::string hint = suggest_keyword(token.text, quoted_words(expected));
    if (!hint.empty()) return hint;
  }
  if (at_ == 0) return "";
  if (at("=") && at("{", 1)) return "leave out the '='";
  const bool after_name = previous().kind == Token::Kind::identifier && !is_keyword(previous());
  const bool touches = previous().span.end == token.span.begin;
  if (after_name && touches && (at("-") || at("."))) return "names consist of A-Z, a-z, 0-9 and '_'";
  const bool is_operand = token.kind == Token::Kind::number || at_name();
  const bool ends_expression = expected == "','" || expected == "')'";
  if (after_name && is_operand && ends_expression && !at("=", 1))
    return fmt::format("write '{}*{}' for the product", previous().text, token.text);
  return "";
}

bool Cursor::at_decimal_comma() const {
  const Token &before = previous(), &comma = peek(), &after = peek(1);
  return at(",") && before.kind == Token::Kind::number && after.kind == Token::Kind::number &&
         before.span.end == comma.span.begin && comma.span.end == after.span.begin;
}

void Cursor::decimal_comma(Span span) {
  error_at(span, "decimal-comma", "write numbers with a decimal point: '1.5', not '1,5'");
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
