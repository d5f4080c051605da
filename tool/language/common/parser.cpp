#include "language/common/parser.h"

#include <fmt/format.h>

#include <algorithm>

namespace robcogen::language {
namespace {

constexpr int kDeepest = 200;   // nested parentheses and signs
constexpr int kLongest = 1000;  // operations in one sum or product

using Kind = Expression::Kind;

ExpressionPtr make(Kind kind, Span span, ExpressionPtr left = nullptr, ExpressionPtr right = nullptr) {
  Expression e;
  e.kind = kind;
  e.span = span;
  e.left = std::move(left);
  e.right = std::move(right);
  return std::make_shared<const Expression>(std::move(e));
}

bool is_pi(const std::string& name) {
  return name.size() == 2 && (name[0] == 'p' || name[0] == 'P') && (name[1] == 'i' || name[1] == 'I');
}

}  // namespace

std::string describe(const Token& token) {
  switch (token.kind) {
    case Token::Kind::end:
      return "the end of the file";
    case Token::Kind::number:
      return fmt::format("number '{}'", token.text);
    default:
      return fmt::format("'{}'", token.text.size() > 60 ? token.text.substr(0, 60) + "…" : token.text);
  }
}

Cursor::Cursor(TokenList list, std::vector<std::string> keywords, Diagnostics& diagnostics)
    : list_(std::move(list)), keywords_(std::move(keywords)), diagnostics_(diagnostics) {
  std::sort(keywords_.begin(), keywords_.end());
}

const Token& Cursor::peek(std::size_t ahead) const {
  return list_.tokens[std::min(at_ + ahead, list_.tokens.size() - 1)];
}

Token Cursor::take() {
  const Token& token = peek();
  if (at_ + 1 < list_.tokens.size()) ++at_;
  return token;
}

bool Cursor::at(std::string_view word, std::size_t ahead) const {
  const Token& token = peek(ahead);
  return token.text == word && !token.escaped &&
         (token.kind == Token::Kind::symbol || token.kind == Token::Kind::identifier);
}

bool Cursor::at_any(std::initializer_list<std::string_view> words) const {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return at(word); });
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
  if (at_keyword()) {
    error("keyword-as-name", fmt::format("'{}' is a keyword and cannot be {}", peek().text, what)).hint =
        fmt::format("write '^{}' to use it as a name", peek().text);
    throw SyntaxError{};
  }
  unexpected(what, "");
}

Diagnostic& Cursor::error(std::string code, std::string message) {
  return error_at(peek().span, std::move(code), std::move(message));
}

Diagnostic& Cursor::error_at(Span span, std::string code, std::string message) {
  return diagnostics_.error(std::move(code), place(span), std::move(message));
}

void Cursor::unexpected(std::string_view expected, std::string_view context) {
  Diagnostic& d = error(
      "unexpected-token",
      fmt::format(
          "expected {}{}, found {}", expected, context.empty() ? "" : fmt::format(" {}", context), describe(peek())));
  if (peek().kind == Token::Kind::identifier && expected.size() > 2 && expected.front() == '\'')
    d.hint = did_you_mean(peek().text, {std::string(expected.substr(1, expected.size() - 2))});
  throw SyntaxError{};
}

void Cursor::skip_to(std::initializer_list<std::string_view> words) {
  for (int nested = 0; !at_end(); take()) {
    if (nested == 0 && (at("}") || at_any(words))) return;
    if (at("{")) ++nested;
    if (at("}")) --nested;
  }
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

// ---------------------------------------------------------------------------------------------------------------------
// Expressions. After a number, a name multiplies it: `2.0 PI`, `2.0a`. So does a negated one when the sign clings to
// the name and not to the number, `2.0 -PI`: `2.0 - PI` and `2.0-PI` subtract.

ExpressionPtr Cursor::expression() {
  return sum();
}

// Long chains are deep trees: both count.
void Cursor::limit(int operations) {
  if (operations <= kLongest) return;
  error("expression-too-long", fmt::format("an expression has more than {} operations", kLongest));
  throw SyntaxError{};
}

Cursor::Nesting::Nesting(Cursor& cursor, Span span) : cursor_(cursor) {
  if (++cursor.depth_ <= kDeepest) return;
  --cursor.depth_;
  cursor.error_at(span, "nesting-too-deep", fmt::format("expressions nest deeper than {} levels", kDeepest));
  throw SyntaxError{};
}

ExpressionPtr Cursor::sum() {
  ExpressionPtr left = product();
  for (int operations = 1; at("+") || at("-"); ++operations) {
    limit(operations);
    const bool add = take().text == "+";
    ExpressionPtr right = product();
    const Span span{left->span.begin, right->span.end};
    left = make(add ? Kind::add : Kind::subtract, span, std::move(left), std::move(right));
  }
  return left;
}

bool Cursor::at_juxtaposed_operand(const Expression& left, std::size_t left_end) const {
  const bool after_number = left.kind == Kind::number || (left.kind == Kind::negate && left.left->kind == Kind::number);
  if (!after_number) return false;
  if (at_name() || at("<")) return true;
  const Token& sign = peek();
  const Token& name = peek(1);
  return at("-") && name.kind == Token::Kind::identifier && !is_keyword(name) && sign.span.end == name.span.begin &&
         sign.span.begin > left_end;
}

ExpressionPtr Cursor::product() {
  ExpressionPtr left = unary();
  for (int operations = 1;; ++operations) {
    const bool juxtaposed = at_juxtaposed_operand(*left, left->span.end);
    if (!juxtaposed && !at("*") && !at("/")) return left;
    limit(operations);
    const bool divide = at("/");
    if (!juxtaposed) take();
    ExpressionPtr right = unary();
    const Span span{left->span.begin, right->span.end};
    left = make(divide ? Kind::divide : Kind::multiply, span, std::move(left), std::move(right));
  }
}

ExpressionPtr Cursor::unary() {
  if (!at("-") && !at("+")) return primary();
  const Token sign = take();
  const Nesting nesting(*this, sign.span);
  ExpressionPtr operand = unary();
  if (sign.text == "+") return operand;
  const Span span{sign.span.begin, operand->span.end};
  if (operand->kind != Kind::number) return make(Kind::negate, span, std::move(operand));
  Expression e = *operand;
  e.span = span;
  e.number = -e.number;
  return std::make_shared<const Expression>(std::move(e));
}

ExpressionPtr Cursor::primary() {
  if (peek().kind == Token::Kind::number) {
    const Token token = take();
    Expression e;
    e.span = token.span;
    e.number = token.number;
    return std::make_shared<const Expression>(std::move(e));
  }
  if (at("(")) {
    const Token open = take();
    const Nesting nesting(*this, open.span);
    ExpressionPtr inner = expression();
    expect(")", "after an expression");
    return inner;
  }
  if (at("<")) return named_constant();
  if (at_name()) return name_or_function();
  unexpected("a number, a name or '('", "");
}

ExpressionPtr Cursor::name_or_function() {
  const Token token = take();
  if (at("(") && !token.escaped) {
    const std::vector<std::pair<std::string, Kind>> functions = {
        {"sin", Kind::sine}, {"cos", Kind::cosine}, {"tan", Kind::tangent}, {"sqrt", Kind::square_root}};
    for (const auto& [name, kind] : functions) {
      if (token.text != name) continue;
      take();
      const Nesting nesting(*this, token.span);
      ExpressionPtr argument = expression();
      const Span span{token.span.begin, expect(")", "after the argument").span.end};
      return make(kind, span, std::move(argument));
    }
    error_at(token.span, "unknown-function", fmt::format("there is no function '{}'", token.text)).hint =
        "functions are sin, cos, tan and sqrt";
    throw SyntaxError{};
  }
  Expression e;
  e.kind = !token.escaped && is_pi(token.text) ? Kind::pi : Kind::name;
  e.span = token.span;
  e.name = token.text;
  e.escaped = token.escaped;
  if (at("[")) {
    take();
    const bool negative = accept("-");
    if (peek().kind != Token::Kind::number) unexpected("a number", "as default of a parameter");
    const Number value = take().number;
    e.kind = Kind::name;
    e.default_value = negative ? -value : value;
    e.span.end = expect("]", "after a default").span.end;
  }
  return std::make_shared<const Expression>(std::move(e));
}

// `<name=3.2>` declares, `<name>` uses.
ExpressionPtr Cursor::named_constant() {
  const Token open = take();
  Expression e;
  e.kind = Kind::constant;
  e.name = expect_name("the name of a constant").text;
  if (accept("=")) {
    const bool negative = accept("-");
    if (peek().kind != Token::Kind::number) unexpected("a number", "as value of a constant");
    Expression value;
    value.number = negative ? -peek().number : peek().number;
    value.span = take().span;
    e.left = std::make_shared<const Expression>(std::move(value));
  }
  e.span = {open.span.begin, expect(">", "after a named constant").span.end};
  return std::make_shared<const Expression>(std::move(e));
}

}  // namespace robcogen::language
