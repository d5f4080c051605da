#include "language/common/lexer.h"

#include <fmt/format.h>

#include <algorithm>

#include "language/common/characters.h"
#include "language/common/malformed_number.h"
#include "language/common/stray_character.h"

namespace robcogen::language {
namespace {

constexpr std::size_t kMaxNameLength = 255;

class Lexer {
 public:
  Lexer(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : text_(source->text()), diagnostics_(diagnostics) {
    list_.source = std::move(source);
  }

  TokenList run() {
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
    if (is_utf16(text_)) {
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
      const bool has_letter = name == "O" || name == "o";
      bad_number(begin, "neither a name nor a number", has_letter ? "write the digit 0, not the letter O" : "");
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
    const std::string hint = hint_to_malformed_number(text_from(begin), text_.substr(at_), at_ > mantissa_end);
    if (peek() == '.' || !hint.empty()) {
      bad_number(begin, "not a decimal number", hint);
      return;
    }
    push(Token::Kind::number, begin, text_from(begin));
    if (!Number::parse(std::string(text_from(begin))))
      error("number-too-large", begin, fmt::format("number {} is too large for a double", quote(text_from(begin))));
  }

  // Reported, but a number for those who read on.
  void bad_number(std::size_t begin, std::string_view what, const std::string& hint) {
    at_ = end_of_malformed_number(text_, at_);
    error("bad-number", begin, fmt::format("{} is {}", quote(text_from(begin)), what)).hint = hint;
    push(Token::Kind::number, begin, text_from(begin));
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

  // A run of meaningless bytes is one error, and so are a pair of quotes and a character that repeats in its line.
  void stray() {
    const std::size_t begin = at_;
    const char c = peek();
    const bool is_repeated = strays_.find(c) != std::string::npos;
    strays_ += c;
    ++at_;
    if (c == '"' || c == '\'') {
      quotes(begin, is_repeated);
      return;
    }
    while (at_ < text_.size() && !is_blank(peek()) && !is_word(peek()) && !is_symbol(peek()) && peek() != '^' &&
           peek() != '$')
      ++at_;
    if (is_repeated) return;
    StrayCharacter found = stray_character(text_, {begin, at_});
    if (found.begins_comment) at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
    error("stray-character", begin, std::move(found.message)).hint = std::move(found.hint);
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
