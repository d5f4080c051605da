#include "language/common/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "language/common/characters.h"
#include "language/common/malformed_number.h"
#include "language/common/stray_character.h"
#include "language/common/text_pieces.h"

namespace robcogen::language {
namespace {

constexpr std::size_t kMaxNameLength = 255;

// Each function below adds the piece of text that begins at `begin`, or reports it, and returns where it ends.
struct Lexing {
  std::string_view text;
  TokenList& list;
  Diagnostics& diagnostics;

  std::string_view piece(Span span) const { return text.substr(span.begin, span.end - span.begin); }
  Diagnostic& error(const char* code, Span span, std::string message) const {
    list.faults.push_back(span);
    return diagnostics.error(code, {list.source, span}, std::move(message));
  }
  Token& push(Token::Kind kind, Span span, std::string_view token) const {
    return list.tokens.emplace_back(Token{kind, false, token, span});
  }
};

std::size_t add_comment(const Lexing& lexing, std::size_t begin) {
  const std::size_t end = end_of_comment(lexing.text, begin);
  if (end == std::string_view::npos) {
    lexing.error("unterminated-comment", {begin, begin + 2}, "this comment does not end: '*/' is missing");
    lexing.list.cut = true;
    return begin + 2;
  }
  std::string comment(lexing.piece({begin, end}));
  while (is_blank(comment.back())) comment.pop_back();
  lexing.list.comments.push_back({std::move(comment), {begin, end}});
  return end;
}

// Reports a malformed number, but adds it as a number so that parsing can continue.
std::size_t add_bad_number(const Lexing& lexing, Span span, std::string_view what, const std::string& hint) {
  lexing.error("bad-number", span, fmt::format("{} is {}", quote(lexing.piece(span)), what)).hint = hint;
  lexing.push(Token::Kind::number, span, lexing.piece(span));
  return span.end;
}

std::size_t add_number(const Lexing& lexing, std::size_t begin) {
  const NumberText number = number_text(lexing.text, begin);
  const Span span = {begin, number.end};
  if (number.is_malformed) return add_bad_number(lexing, span, "not a decimal number", number.hint);
  const std::string_view text = lexing.piece(span);
  lexing.push(Token::Kind::number, span, text);
  if (!Number::parse(std::string(text)))
    lexing.error("number-too-large", span, fmt::format("number {} is too large for a double", quote(text)));
  return span.end;
}

std::size_t add_identifier(const Lexing& lexing, std::size_t begin) {
  const std::string_view text = lexing.text;
  const bool escaped = text[begin] == '^';
  const std::size_t first = begin + (escaped ? 1 : 0), end = end_of_word(text, first);
  const std::string_view name = lexing.piece({first, end});
  if (!escaped && character(text, end) == '.' && is_digit(character(text, end + 1))) {
    const bool has_letter = name == "O" || name == "o";
    return add_bad_number(
        lexing, {begin, end_of_malformed_number(text, end)}, "neither a name nor a number",
        has_letter ? "write the digit 0, not the letter O" : "");
  }
  lexing.push(Token::Kind::identifier, {begin, end}, name.substr(0, kMaxNameLength)).escaped = escaped;
  if (name.size() > kMaxNameLength)
    lexing.error(
        "name-too-long", {begin, end},
        fmt::format("this name has {} characters; at most {} are allowed", name.size(), kMaxNameLength));
  return end;
}

// Whether this is the point of `group.name`, or of `group.^name`.
bool at_member(std::string_view text, std::size_t at) {
  const std::size_t name = at + (character(text, at + 1) == '^' ? 2 : 1);
  return text[at] == '.' && at > 0 && is_word(text[at - 1]) && is_letter(character(text, name));
}

std::size_t add_symbol(const Lexing& lexing, std::size_t begin) {
  const std::string_view two = lexing.text.substr(begin, 2);
  const std::size_t end = begin + (two == "->" || two == "<-" ? 2 : 1);
  lexing.push(Token::Kind::symbol, {begin, end}, lexing.piece({begin, end}));
  return end;
}

bool is_after_import(const Lexing& lexing) {
  if (lexing.list.tokens.empty()) return false;
  const Token& word = lexing.list.tokens.back();
  return word.kind == Token::Kind::identifier && !word.escaped && word.text == "import";
}

// Whether this is `"…"` after the word `import`.
bool at_file_name(const Lexing& lexing, std::size_t at) {
  return is_after_import(lexing) && end_of_quoted(lexing.text, at) != std::string_view::npos;
}

std::size_t add_file_name(const Lexing& lexing, std::size_t begin) {
  const std::size_t end = end_of_quoted(lexing.text, begin);
  lexing.push(Token::Kind::string, {begin, end}, lexing.piece({begin + 1, end - 1}));
  return end;
}

std::size_t report_placeholder(const Lexing& lexing, std::size_t begin) {
  std::size_t end = std::min(lexing.text.find_first_of("}\r\n", begin), lexing.text.size());
  if (character(lexing.text, end) == '}') ++end;
  lexing.error("template", {begin, end}, "'${…}' is a placeholder: this is a template, not yet a document").hint =
      "fill in the template first";
  lexing.list.cut = true;
  return end;
}

// The characters reported on the present line: a repeated character is reported once.
struct ReportedStrays {
  std::string characters;
  std::size_t closing_quote = std::string_view::npos;  // of a pair of quotes

  // Returns whether the character is new.
  bool add(char c) {
    const bool is_new = characters.find(c) == std::string::npos;
    characters += c;
    return is_new;
  }
};

// The text between the quotes is read as if there were no quotes.
std::size_t report_quotes(const Lexing& lexing, std::size_t begin, ReportedStrays& strays) {
  const char quote = lexing.text[begin];
  const bool is_new = strays.add(quote);
  const std::size_t closing = lexing.text.find(quote, begin + 1), end = begin + 1;
  const bool is_closed = closing < end_of_line(lexing.text, end);
  if (is_closed) strays.closing_quote = closing;
  if (!is_new) return end;
  lexing.error("stray-character", {begin, is_closed ? closing + 1 : end}, fmt::format("unexpected character {}", quote))
      .hint = is_after_import(lexing) ? "write the name of a file in double quotes, as in 'import \"leg.kindsl\"'"
                                      : "write names and numbers without quotes";
  lexing.list.faults.back().end = end;
  return end;
}

// A run of meaningless bytes, or a pair of quotes, is reported as one error.
std::size_t report_stray(const Lexing& lexing, std::size_t begin, ReportedStrays& strays) {
  const std::string_view text = lexing.text;
  if (text[begin] == '"' || text[begin] == '\'') return report_quotes(lexing, begin, strays);
  std::size_t end = end_of_stray_run(text, begin);
  if (!strays.add(text[begin])) return end;
  StrayCharacter found = stray_character(text, {begin, end});
  if (found.begins_comment) end = end_of_line(text, end);
  lexing.error("stray-character", {begin, end}, std::move(found.message)).hint = std::move(found.hint);
  return end;
}

std::size_t add_piece(const Lexing& lexing, std::size_t at, ReportedStrays& strays) {
  const char c = lexing.text[at], next = character(lexing.text, at + 1);
  if (begins_comment(lexing.text, at)) return add_comment(lexing, at);
  if (is_letter(c) || (c == '^' && is_letter(next))) return add_identifier(lexing, at);
  if (is_digit(c) || (c == '.' && is_digit(next))) return add_number(lexing, at);
  if (is_symbol(c) || at_member(lexing.text, at)) return add_symbol(lexing, at);
  if (at_file_name(lexing, at)) return add_file_name(lexing, at);
  if (c == '$' && next == '{') return report_placeholder(lexing, at);
  return report_stray(lexing, at, strays);
}

void add_pieces(const Lexing& lexing, std::size_t at) {
  ReportedStrays strays;
  while (at < lexing.text.size() && !lexing.list.cut) {
    const char c = lexing.text[at];
    if (c == '\n' || c == '\r') strays = {};
    at = is_blank(c) || at == strays.closing_quote ? at + 1 : add_piece(lexing, at, strays);
  }
}

}  // namespace

TokenList tokenize(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  TokenList list;
  list.source = std::move(source);
  const Lexing lexing = {list.source->text(), list, diagnostics};
  const std::size_t begin = lexing.text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  if (is_utf16(lexing.text)) {
    lexing.error("not-utf-8", {0, begin}, "the file is in UTF-16").hint = "save it as UTF-8";
    list.cut = true;
  }
  add_pieces(lexing, begin);
  // Blank lines at the end are ignored.
  const std::size_t end = lexing.text.find_last_not_of(" \t\r\n") + 1;
  lexing.push(Token::Kind::end, {end, end}, "");
  return list;
}

Number number_of(const Token& token) {
  return Number::parse(std::string(token.text)).value_or(Number());
}

std::string quote(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  return text.size() <= kLongest ? fmt::format("'{}'", text) : fmt::format("'{}…'", text.substr(0, kLongest));
}

}  // namespace robcogen::language
