#include "language/common/lexer.h"

#include <fmt/format.h>

#include <algorithm>

namespace robcogen::language {
namespace {

constexpr std::string_view kSymbols = "{}()[]=,:+-*/<>";
constexpr std::size_t kLongestName = 255;

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
bool is_symbol(char c) {
  return kSymbols.find(c) != std::string_view::npos;
}

class Lexer {
 public:
  Lexer(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : text_(source->text()), diagnostics_(diagnostics) {
    list_.source = std::move(source);
  }

  TokenList run() {
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
    if (is_utf16()) {
      error("not-utf-8", 0, "the file is in UTF-16").hint = "save it as UTF-8";
      list_.cut = true;
    }
    while (at_ < text_.size() && !list_.cut) next();
    // The end is where the text ends, not where blank lines after it do.
    const std::size_t end = text_.find_last_not_of(" \t\r\n") + 1;
    list_.tokens.push_back({Token::Kind::end, false, "", {end, end}});
    return std::move(list_);
  }

 private:
  std::string_view text_;
  Diagnostics& diagnostics_;
  TokenList list_;
  std::size_t at_ = 0;

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  std::string_view text_from(std::size_t begin) const { return text_.substr(begin, at_ - begin); }

  bool is_utf16() const {
    if (text_.size() < 2) return false;
    const bool marked = text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff");
    return marked || (text_[0] == '\0') != (text_[1] == '\0');
  }

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
    } else if (is_symbol(c) || at_member()) {
      symbol();
    } else if (c == '$' && peek(1) == '{') {
      placeholder();
    } else {
      stray();
    }
  }

  // The error is at the text from there to the present place.
  Diagnostic& error(const char* code, std::size_t begin, std::string message) {
    return diagnostics_.error(code, {list_.source, {begin, at_}}, std::move(message));
  }

  Token& push(Token::Kind kind, std::size_t begin, std::string_view text) {
    return list_.tokens.emplace_back(Token{kind, false, text, {begin, at_}});
  }

  void comment() {
    const std::size_t begin = at_;
    if (peek(1) == '/') {
      at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
    } else {
      const std::size_t end = text_.find("*/", at_ + 2);
      if (end == std::string_view::npos) {
        at_ += 2;
        error("unterminated-comment", begin, "this comment does not end");
        list_.cut = true;
        return;
      }
      at_ = end + 2;
    }
    std::string text(text_from(begin));
    while (is_blank(text.back())) text.pop_back();
    list_.comments.push_back({std::move(text), {begin, at_}});
  }

  void identifier() {
    const std::size_t begin = at_;
    const bool escaped = peek() == '^';
    if (escaped) ++at_;
    const std::size_t first = at_;
    while (is_word(peek())) ++at_;
    const std::string_view name = text_from(first);
    push(Token::Kind::identifier, begin, name.substr(0, kLongestName)).escaped = escaped;
    if (name.size() > kLongestName)
      error("name-too-long", begin, fmt::format("a name of more than {} characters", kLongestName));
  }

  // Digits, point, exponent. What follows at once may be a name, which multiplies: `2.0a`; unless it reads like a
  // number of another language.
  void number() {
    const std::size_t begin = at_;
    digits();
    if (peek() == '.') {
      ++at_;
      digits();
    }
    const std::size_t mantissa_end = at_;
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
      at_ += 1 + sign;
      digits();
    }
    const std::string hint = hint_to_malformed_number(begin, at_ > mantissa_end);
    if (peek() == '.' || !hint.empty()) {
      skip_malformed_number();
      error("bad-number", begin, fmt::format("{} is not a decimal number", quote(text_from(begin)))).hint = hint;
      push(Token::Kind::number, begin, text_from(begin));
      return;
    }
    push(Token::Kind::number, begin, text_from(begin));
    if (!Number::parse(std::string(text_from(begin))))
      error("number-too-large", begin, fmt::format("{} is too large a number", quote(text_from(begin))));
  }

  // Letters, digits and points, and the sign of an exponent.
  void skip_malformed_number() {
    const auto at_sign = [&] {
      const char before = text_[at_ - 1];
      return (before == 'e' || before == 'E') && (peek() == '+' || peek() == '-');
    };
    while (is_word(peek()) || peek() == '.' || at_sign()) ++at_;
  }

  // What to write for a number that runs into letters as numbers of other languages do; empty where none follow, or
  // they are a name.
  std::string hint_to_malformed_number(std::size_t begin, bool has_exponent) const {
    std::size_t end = at_;
    while (end < text_.size() && is_word(text_[end])) ++end;
    const std::string_view number = text_from(begin), word = text_.substr(at_, end - at_);
    if (word.empty()) return "";
    const std::string_view tail = word.substr(1);
    const bool counts = !tail.empty() && std::all_of(tail.begin(), tail.end(), is_digit);
    const auto begins_with = [&](char letter) { return (word[0] | 0x20) == letter; };
    if (number == "0" && (begins_with('x') || (begins_with('b') && counts))) return "write the number in base ten";
    const std::size_t not_underscore = std::min(word.find_first_not_of('_'), word.size());
    if (not_underscore > 0 && (not_underscore == word.size() || is_digit(word[not_underscore])))
      return "write digits without separators";
    const std::string product = fmt::format("'{0} {1}' for {0} times '{1}'", number, word);
    if (begins_with('e') && tail.empty()) return fmt::format("write digits behind the '{}', or {}", word, product);
    if (begins_with('e') && counts && has_exponent) return "write one exponent";
    if (begins_with('d') && counts)
      return fmt::format("write '{}e{}' for a power of ten, or {}", number, tail, product);
    if (begins_with('f') && tail.empty()) return fmt::format("write '{}', or {}", number, product);
    return "";
  }

  void digits() {
    while (is_digit(peek())) ++at_;
  }

  // The point of `group.name`.
  bool at_member() const { return peek() == '.' && at_ > 0 && is_word(text_[at_ - 1]) && is_letter(peek(1)); }

  void symbol() {
    const std::size_t begin = at_;
    const bool is_arrow = (peek() == '-' && peek(1) == '>') || (peek() == '<' && peek(1) == '-');
    at_ += is_arrow ? 2 : 1;
    push(Token::Kind::symbol, begin, text_from(begin));
  }

  void placeholder() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of("}\r\n", at_), text_.size());
    if (peek() == '}') ++at_;
    error("template", begin, "'${…}' is a placeholder: this is a template, not yet a document").hint =
        "fill in the template first";
    list_.cut = true;
  }

  // Nothing but blanks stands before it in its line.
  bool begins_line(std::size_t at) const {
    const std::size_t last = text_.substr(0, at).find_last_not_of(" \t");
    return last == std::string_view::npos || text_[last] == '\n' || text_[last] == '\r';
  }

  // A run of bytes that mean nothing is one error.
  void stray() {
    const std::size_t begin = at_;
    const auto byte = static_cast<unsigned char>(peek());
    ++at_;
    while (at_ < text_.size() && !is_blank(peek()) && !is_word(peek()) && !is_symbol(peek()) && peek() != '^' &&
           peek() != '$')
      ++at_;
    if (byte >= 0x80) {
      error("stray-character", begin, "unexpected character outside ASCII").hint =
          "names consist of A-Z, a-z, 0-9 and '_'; any text may stand in a comment";
    } else if (byte == '#' || (byte == ';' && begins_line(begin))) {
      at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
      error("stray-character", begin, fmt::format("unexpected character '{}'", text_[begin])).hint =
          "a comment begins with '//'";
    } else if (byte == ';') {
      error("stray-character", begin, "unexpected character ';'").hint =
          "leave it out: nothing stands between items, and a comment begins with '//'";
    } else if (byte > 0x20 && byte < 0x7f) {
      error("stray-character", begin, fmt::format("unexpected character '{}'", text_[begin]));
    } else {
      error("stray-character", begin, fmt::format("unexpected byte 0x{:02x}", byte));
    }
  }
};

}  // namespace

TokenList tokenize(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Lexer(std::move(source), diagnostics).run();
}

Number number_of(const Token& token) {
  return Number::parse(std::string(token.text)).value_or(Number());
}

std::string quote(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  return text.size() <= kLongest ? fmt::format("'{}'", text) : fmt::format("'{}…'", text.substr(0, kLongest));
}

}  // namespace robcogen::language
