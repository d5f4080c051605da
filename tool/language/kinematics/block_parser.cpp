#include "language/kinematics/block_parser.h"

#include <algorithm>
#include <climits>

#include "language/common/parse_expression.h"

namespace robcogen::language::kinematics {
namespace {

const WordList kPlacementItems = {"translation", "rotation"};

}  // namespace

std::string quoted(WordList words) {
  std::string text;
  for (std::string_view word : words) text += fmt::format("'{}', ", word);
  text.resize(text.size() - 2);
  return text;
}

bool BlockParser::at_element() const {
  const bool has_name = cursor_.peek(1).kind == Token::Kind::identifier;
  return at_new_element() || (cursor_.at_any(kElements) && has_name && (cursor_.at_name(1) || cursor_.at("{", 2)));
}

bool BlockParser::at_new_element() const {
  return cursor_.at_any(kNewElements) && cursor_.at_name(1) && cursor_.at("{", 2);
}

void BlockParser::report_missing_brace(const std::string& owner, const Token& open) {
  cursor_
      .error("missing-brace", fmt::format("expected '}}' at the end of {}, found {}", owner, describe(cursor_.peek())))
      .notes.push_back({cursor_.place(open.span), "opened here"});
}

void BlockParser::missing_brace(const std::string& owner, const Token& open) {
  report_missing_brace(owner, open);
  throw SyntaxError{};
}

void BlockParser::report_second_brace() {
  cursor_.error("extra-brace", "unexpected second '{'");
  cursor_.take();
  cursor_.assume_closing_brace();
}

void BlockParser::report_extra_brace(const std::string& owner, const Token& brace) {
  cursor_.error_at(brace.span, "extra-brace", fmt::format("this '}}' ends {} before its last item", owner))
      .notes.push_back({cursor_.place(cursor_.peek().span), "the next item is here"});
}

void BlockParser::report_repetition(const Token& token, const Token& earlier) {
  cursor_.error_at(token.span, "duplicate-item", fmt::format("'{}' is given twice", token.text))
      .notes.push_back({cursor_.place(earlier.span), "first given here"});
}

Token BlockParser::word(Words& found) {
  const Token token = cursor_.take();
  if (cursor_.at(token.text)) {
    report_repetition(cursor_.peek(), token);
    cursor_.take();
  }
  const auto is_inertia = [](const Token& t) { return t.text.starts_with("inertia_"); };
  for (const Token& earlier : found) {
    if (earlier.text != token.text && !(is_inertia(earlier) && is_inertia(token))) continue;
    report_repetition(token, earlier);
    return token;
  }
  found.push_back(token);
  return token;
}

bool BlockParser::check_complete(const std::string& owner, Span span, const Words& found, WordList words) {
  std::string missing;
  for (std::string_view word : words) {
    if (std::any_of(found.begin(), found.end(), [&](const Token& t) { return t.text == word; })) continue;
    missing += fmt::format("{}'{}'", missing.empty() ? "" : ", ", word);
  }
  if (!missing.empty()) cursor_.error_at(span, "missing-item", fmt::format("{} has no {}", owner, missing));
  return missing.empty();
}

void BlockParser::unknown_item(const std::string& owner, WordList words) {
  if (cursor_.is_faulty_here()) throw SyntaxError{};
  const Token& token = cursor_.peek();
  Diagnostic& d = cursor_.error(
      "unknown-item", fmt::format("expected {} or '}}' in {}, found {}", quoted(words), owner, describe(token)));
  if (token.kind == Token::Kind::identifier) d.hint = suggest_keyword(token.text, {words.begin(), words.end()});
  throw SyntaxError{};
}

void BlockParser::old_dialect(const std::string& sign) {
  cursor_.error("old-dialect", sign + " belongs to the dialect of 2011-2012, which is not supported").hint =
      "write translation = (x, y, z), inertia_params { mass = m CoM = (x, y, z) Ix = … }";
  throw OtherLanguage{};
}

Name BlockParser::name(std::string_view what) {
  const Token token = cursor_.expect_name(what);
  return {std::string(token.text), token.span};
}

void BlockParser::equals(const Token& key) {
  const bool is_of_placement = key.text == "translation" || key.text == "rotation";
  if (cursor_.at(":") && is_of_placement) old_dialect(fmt::format("'{} :'", key.text));
  cursor_.expect("=", fmt::format("after '{}'", key.text));
}

int BlockParser::integer(const Token& key) {
  equals(key);
  const bool is_negative = cursor_.at("-") && cursor_.peek(1).kind == Token::Kind::number;
  const Token token = cursor_.peek(is_negative ? 1 : 0);
  const bool is_integer = !is_negative && token.kind == Token::Kind::number &&
                          token.text.find_first_not_of("0123456789") == std::string::npos &&
                          number_of(token).value() <= INT_MAX;
  if (!is_integer) {
    const std::string expected = fmt::format("an integer from 0 to {}", INT_MAX);
    if (cursor_.after_line_end() || cursor_.is_faulty_here()) cursor_.unexpected(expected, "after '='");
    const Span span = {cursor_.peek().span.begin, token.span.end};
    const std::string found = is_negative ? fmt::format("number '-{}'", token.text) : describe(token);
    cursor_.error_at(span, "bad-id", fmt::format("expected {} as id, found {}", expected, found));
    throw SyntaxError{};
  }
  cursor_.take();
  return static_cast<int>(number_of(token).value());
}

ExpressionPtr BlockParser::scalar() {
  ExpressionPtr value = parse_expression(cursor_);
  if (cursor_.at_decimal_comma()) cursor_.decimal_comma(cursor_.peek().span);
  return value;
}

std::vector<ExpressionPtr> BlockParser::components(const Token& key, std::size_t count) {
  const char* number = count == 3 ? "three" : "two";
  const Token open = cursor_.expect("(", fmt::format("before the {} components of '{}'", number, key.text));
  std::vector<ExpressionPtr> found = {parse_expression(cursor_)};
  std::optional<Span> comma;
  while (cursor_.at(",")) {
    if (!comma && cursor_.at_decimal_comma()) comma = cursor_.peek().span;
    cursor_.take();
    found.push_back(parse_expression(cursor_));
  }
  if (!cursor_.at(")") && found.size() < count)
    cursor_.unexpected("','", fmt::format("after a component of '{}'", key.text));
  const Token close = cursor_.expect(")", fmt::format("after the components of '{}'", key.text));
  if (found.size() == count) return found;
  if (found.size() > count && comma) cursor_.decimal_comma(*comma);
  cursor_.error_at(
      {open.span.begin, close.span.end}, "component-count",
      fmt::format("'{}' needs {} components, found {}", key.text, count, found.size()));
  throw SyntaxError{};
}

Vector BlockParser::vector(const Token& key) {
  const std::vector<ExpressionPtr> found = components(key, 3);
  return {found[0], found[1], found[2]};
}

std::optional<Placement> BlockParser::placement(const std::string& owner, Span owner_span) {
  Placement placement;
  placement.span.begin = cursor_.peek().span.begin;
  Words found;
  const bool sound = block(owner, kPlacementItems, [&] {
    if (!cursor_.at_any(kPlacementItems)) unknown_item(owner, kPlacementItems);
    const Token key = word(found);
    equals(key);
    (key.text == "translation" ? placement.translation : placement.rotation) = vector(key);
  });
  placement.span.end = cursor_.previous().span.end;
  if (!sound || !check_complete(owner, owner_span, found, kPlacementItems)) return std::nullopt;
  return placement;
}

}  // namespace robcogen::language::kinematics
