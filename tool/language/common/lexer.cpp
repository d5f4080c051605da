#include "language/common/lexer.h"

#include <fmt/format.h>

#include <algorithm>

namespace robcogen::language {
namespace {

constexpr std::string_view kSymbols = "{}()[]=,:+-*/<>~";
constexpr std::size_t kMaxNameLength = 255;

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
    // Blank lines at the end do not count.
    const std::size_t end = text_.find_last_not_of(" \t\r\n") + 1;
    list_.tokens.push_back({Token::Kind::end, false, "", {end, end}});
    return std::move(list_);
  }

 private:
  std::string_view text_;
  Diagnostics& diagnostics_;
  TokenList list_;
  std::size_t at_ = 0;
  std::size_t closing_quote_ = std::string_view::npos;  // of quotes that were reported
  std::string strays_;                                  // characters that were reported in the present line

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  std::string_view text_from(std::size_t begin) const { return text_.substr(begin, at_ - begin); }

  bool is_utf16() const {
    if (text_.size() < 2) return false;
    const bool marked = text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff");
    return marked || (text_[0] == '\0') != (text_[1] == '\0');
  }

  void next() {
    const char c = peek();
    if (is_blank(c) || at_ == closing_quote_) {
      if (c == '\n' || c == '\r') strays_.clear();
      ++at_;
    } else if (c == '/' && (peek(1) == '/' || peek(1) == '*')) {
      comment();
    } else if (is_letter(c) || (c == '^' && is_letter(peek(1)))) {
      identifier();
    } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
      number();
    } else if (is_symbol(c) || at_member()) {
      symbol();
    } else if (at_file_name()) {
      file_name();
    } else if (c == '$' && peek(1) == '{') {
      placeholder();
    } else {
      stray();
    }
  }

  // The error covers the text from `begin` to the present place.
  Diagnostic& error(const char* code, std::size_t begin, std::string message) {
    list_.faults.push_back({begin, at_});
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
        error("unterminated-comment", begin, "this comment does not end: '*/' is missing");
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
    if (!escaped && peek() == '.' && is_digit(peek(1))) {
      skip_malformed_number();
      Diagnostic& fault =
          error("bad-number", begin, fmt::format("{} is neither a name nor a number", quote(text_from(begin))));
      if (name == "O" || name == "o") fault.hint = "write the digit 0, not the letter O";
      push(Token::Kind::number, begin, text_from(begin));
      return;
    }
    push(Token::Kind::identifier, begin, name.substr(0, kMaxNameLength)).escaped = escaped;
    if (name.size() > kMaxNameLength)
      error(
          "name-too-long", begin,
          fmt::format("this name has {} characters; at most {} are allowed", name.size(), kMaxNameLength));
  }

  // Digits, point, exponent. A name that follows without a blank multiplies (`2.0a`), unless the text reads like a
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
      error("number-too-large", begin, fmt::format("number {} is too large for a double", quote(text_from(begin))));
  }

  // Letters, digits and points, and the sign of an exponent.
  void skip_malformed_number() {
    const auto at_sign = [&] {
      const char before = text_[at_ - 1];
      return (before == 'e' || before == 'E') && (peek() == '+' || peek() == '-');
    };
    while (is_word(peek()) || peek() == '.' || at_sign()) ++at_;
  }

  // The hint for a number with letters at its end, as other languages write numbers; empty when no letters follow, or
  // when they are a name.
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
    if (begins_with('e') && tail.empty()) return fmt::format("write digits after the '{}', or {}", word, product);
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

  // `"…"` in one line, after the word `import`.
  bool at_file_name() const {
    if (peek() != '"' || list_.tokens.empty()) return false;
    const Token& word = list_.tokens.back();
    if (word.kind != Token::Kind::identifier || word.escaped || word.text != "import") return false;
    const std::size_t end = text_.find_first_of("\"\r\n", at_ + 1);
    return end != std::string_view::npos && text_[end] == '"';
  }

  void file_name() {
    const std::size_t begin = at_;
    at_ = text_.find('"', at_ + 1) + 1;
    push(Token::Kind::string, begin, text_.substr(begin + 1, at_ - begin - 2));
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

  // A run of meaningless bytes is one error, and so are a pair of quotes and a character that repeats in its line.
  void stray() {
    const std::size_t begin = at_;
    const auto byte = static_cast<unsigned char>(peek());
    const bool is_repeated = strays_.find(peek()) != std::string::npos;
    strays_ += peek();
    ++at_;
    if (byte == '"' || byte == '\'') {
      quotes(begin, is_repeated);
      return;
    }
    while (at_ < text_.size() && !is_blank(peek()) && !is_word(peek()) && !is_symbol(peek()) && peek() != '^' &&
           peek() != '$')
      ++at_;
    if (is_repeated) return;
    if (byte >= 0x80) {
      error("stray-character", begin, "unexpected character outside ASCII").hint =
          "names consist of A-Z, a-z, 0-9 and '_'; comments may hold any text";
    } else if (byte == '#' || (byte == ';' && begins_line(begin))) {
      at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
      error("stray-character", begin, fmt::format("unexpected character '{}'", text_[begin])).hint =
          "a comment begins with '//'";
    } else if (byte == ';') {
      error("stray-character", begin, "unexpected character ';'").hint =
          "items need no separator, components and names of a list are separated by ',', a comment begins with '//'";
    } else if (byte == '^' && at_ < text_.size() && is_word(peek())) {
      error("stray-character", begin, "unexpected character '^'").hint =
          "write a power as a product; '^' stands only before a name that is a keyword";
    } else if (byte > 0x20 && byte < 0x7f) {
      error("stray-character", begin, fmt::format("unexpected character '{}'", text_[begin]));
    } else {
      error("stray-character", begin, fmt::format("unexpected byte 0x{:02x}", byte));
    }
  }

  // The text between quotes is read as if they were absent.
  void quotes(std::size_t begin, bool is_repeated) {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    const std::size_t closing = text_.find(text_[begin], at_);
    if (closing < end) {
      closing_quote_ = closing;
      at_ = closing + 1;
    }
    if (!is_repeated)
      error("stray-character", begin, fmt::format("unexpected character {}", text_[begin])).hint =
          "write names and numbers without quotes";
    if (!is_repeated) list_.faults.back().end = begin + 1;
    at_ = begin + 1;
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
