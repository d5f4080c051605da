#include "language/common/lexer.h"

#include <fmt/format.h>

#include <string_view>

namespace robcogen::language {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_word(char c) {
  return is_letter(c) || is_digit(c);
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

class Lexer {
 public:
  Lexer(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : text_(source->text()), diagnostics_(diagnostics) {
    list_.source = std::move(source);
  }

  TokenList run() {
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // byte order mark
    while (at_ < text_.size()) next();
    list_.tokens.push_back({Token::Kind::end, "", false, {}, {text_.size(), text_.size()}});
    return std::move(list_);
  }

 private:
  std::string_view text_;
  Diagnostics& diagnostics_;
  TokenList list_;
  std::size_t at_ = 0;

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void next() {
    const char c = peek();
    if (is_blank(c)) {
      ++at_;
    } else if (c == '/' && (peek(1) == '/' || peek(1) == '*')) {
      comment();
    } else if (is_letter(c) || (c == '^' && is_letter(peek(1)))) {
      identifier();
    } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
      number();
    } else if (std::string_view("{}()[]=,:+-*/<>$").find(c) != std::string_view::npos) {
      symbol();
    } else {
      stray();
    }
  }

  void push(Token::Kind kind, std::size_t begin, std::string text) {
    list_.tokens.push_back({kind, std::move(text), false, {}, {begin, at_}});
  }

  void comment() {
    const std::size_t begin = at_;
    if (peek(1) == '/') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else {
      const std::size_t end = text_.find("*/", at_ + 2);
      at_ = end == std::string_view::npos ? text_.size() : end + 2;
      if (end == std::string_view::npos)
        diagnostics_.error("unterminated-comment", {list_.source, {begin, begin + 2}}, "this comment does not end");
    }
    std::string text(text_.substr(begin, at_ - begin));
    while (!text.empty() && is_blank(text.back())) text.pop_back();
    list_.comments.push_back({std::move(text), {begin, at_}});
  }

  void identifier() {
    const std::size_t begin = at_;
    const bool escaped = peek() == '^';
    if (escaped) ++at_;
    const std::size_t first = at_;
    while (is_word(peek())) ++at_;
    push(Token::Kind::identifier, begin, std::string(text_.substr(first, at_ - first)));
    list_.tokens.back().escaped = escaped;
  }

  // digits, point, exponent; what follows directly must not look like more of a number. `2.0a` and `2.0PI` are a number
  // and a name.
  void number() {
    const std::size_t begin = at_;
    while (is_digit(peek())) ++at_;
    if (peek() == '.') {
      ++at_;
      while (is_digit(peek())) ++at_;
    }
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
      at_ += 2 + sign;
      while (is_digit(peek())) ++at_;
    }
    const std::string literal(text_.substr(begin, at_ - begin));
    const bool hexadecimal = literal == "0" && (peek() == 'x' || peek() == 'X');
    if (hexadecimal || peek() == '.') {
      while (is_word(peek()) || peek() == '.') ++at_;
      fault("bad-number", begin, fmt::format("'{}' is no decimal number", text_.substr(begin, at_ - begin)));
      push(Token::Kind::number, begin, "0.0");
      return;
    }
    const std::optional<Number> value = Number::parse(literal);
    if (!value) fault("number-range", begin, fmt::format("'{}' is beyond the range of numbers", literal));
    push(Token::Kind::number, begin, literal);
    list_.tokens.back().number = value.value_or(Number());
  }

  void symbol() {
    const std::size_t begin = at_;
    const bool arrow = (peek() == '-' && peek(1) == '>') || (peek() == '<' && peek(1) == '-');
    at_ += arrow ? 2 : 1;
    push(Token::Kind::symbol, begin, std::string(text_.substr(begin, at_ - begin)));
  }

  // A run of bytes that mean nothing is one error.
  void stray() {
    const std::size_t begin = at_;
    const auto meaningless = [&](char c) {
      return !is_blank(c) && !is_word(c) && std::string_view("{}()[]=,:+-*/<>$.^").find(c) == std::string_view::npos;
    };
    ++at_;
    while (at_ < text_.size() && meaningless(text_[at_])) ++at_;
    const auto byte = static_cast<unsigned char>(text_[begin]);
    const bool printable = byte > 0x20 && byte < 0x7f;
    fault(
        "stray-character", begin,
        printable ? fmt::format("unexpected character '{}'", text_[begin])
                  : fmt::format("unexpected byte 0x{:02x}", byte));
  }

  void fault(const char* code, std::size_t begin, std::string message) {
    diagnostics_.error(code, {list_.source, {begin, at_}}, std::move(message));
  }
};

}  // namespace

TokenList tokenize(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Lexer(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language
