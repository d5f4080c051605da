#include "language/common/parse_expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "language/common/parse_named_value.h"

namespace robcogen::language {
namespace {

using Kind = Expression::Kind;

constexpr int kMaxDepth = 200;       // nested parentheses, functions and signs
constexpr int kMaxOperations = 500;  // in one expression

constexpr std::array kFunctions = {
    std::pair("sin", Kind::sine), std::pair("cos", Kind::cosine), std::pair("tan", Kind::tangent),
    std::pair("sqrt", Kind::square_root)};

ExpressionPtr operation(
    Kind kind,
    Span span,
    ExpressionPtr left,
    ExpressionPtr right = nullptr,
    bool juxtaposed = false) {
  Expression e;
  e.kind = kind;
  e.span = span;
  e.left = std::move(left);
  e.right = std::move(right);
  e.juxtaposed = juxtaposed;
  return std::make_shared<const Expression>(std::move(e));
}

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

class ExpressionParser {
 public:
  explicit ExpressionParser(Cursor& cursor) : cursor_(cursor) {}

  ExpressionPtr run() { return at_signed_product() ? signed_product() : sum(); }

 private:
  Cursor& cursor_;
  int depth_ = 0;
  int operations_ = 0;

  // Whether the cursor is at `2.0 -PI` and nothing else.
  bool at_signed_product() const {
    const std::size_t first = cursor_.at("-") ? 1 : 0;
    const Token &number = cursor_.peek(first), &sign = cursor_.peek(first + 1), &name = cursor_.peek(first + 2);
    if (number.kind != Token::Kind::number || !cursor_.at("-", first + 1) || !cursor_.at_name(first + 2)) return false;
    if (number.span.end == sign.span.begin || sign.span.end != name.span.begin) return false;
    constexpr std::array kContinues = {"+", "-", "*", "/", "(", "[", "="};
    return std::none_of(
        kContinues.begin(), kContinues.end(), [&](const char* symbol) { return cursor_.at(symbol, first + 3); });
  }

  // The sign is moved to the number: `-2.0 PI` cannot be read as a difference.
  ExpressionPtr signed_product() {
    const std::size_t begin = cursor_.peek().span.begin;
    const bool negative = cursor_.accept("-");
    const Token number = cursor_.take();
    cursor_.take();  // the sign
    ExpressionPtr name = name_or_function();
    const Span span{begin, name->span.end};
    cursor_
        .warning_at(
            span, "signed-product",
            fmt::format(
                "this is read as the product of {}{} and -{}, as in the first RobCoGen", negative ? "-" : "",
                number.text, name->name))
        .hint = fmt::format(
        "write '{0}{1} {2}' for the product, '{3}{1} - {2}' for the difference", negative ? "" : "-", number.text,
        name->name, negative ? "-" : "");
    ExpressionPtr factor = literal({begin, number.span.end}, negative ? number_of(number) : -number_of(number));
    return operation(Kind::multiply, span, std::move(factor), std::move(name));
  }

  ExpressionPtr sum() {
    ExpressionPtr left = product();
    while (cursor_.at("+") || cursor_.at("-")) {
      count_operation();
      const Kind kind = cursor_.take().text == "+" ? Kind::add : Kind::subtract;
      ExpressionPtr right = product();
      const Span span{left->span.begin, right->span.end};
      left = operation(kind, span, std::move(left), std::move(right));
    }
    return left;
  }

  // Whether the cursor is at `name =`, `name {`, `instance.name =` or `for name in`, which end an expression.
  bool begins_item() const {
    if (cursor_.at("=", 1) || cursor_.at("{", 1)) return true;
    return (cursor_.at(".", 1) && cursor_.at_name(2) && cursor_.at("=", 3)) ||
           (cursor_.at("for") && cursor_.at_name(1) && cursor_.at("in", 2));
  }

  ExpressionPtr product() {
    bool ends_in_number = false;
    ExpressionPtr left = unary(ends_in_number);
    while (true) {
      const bool next_is_name = cursor_.at_name() && !begins_item();
      const bool juxtaposed = ends_in_number && (next_is_name || cursor_.at("<"));
      if (!juxtaposed && !cursor_.at("*") && !cursor_.at("/")) return left;
      count_operation();
      const Kind kind = cursor_.at("/") ? Kind::divide : Kind::multiply;
      if (!juxtaposed) cursor_.take();
      ExpressionPtr right = unary(ends_in_number);
      const Span span{left->span.begin, right->span.end};
      // `0.01 / 2.0 PI` looks like 0.01 / (2.0 PI) and is (0.01 / 2.0) PI. Units of couplings cannot be meant
      // otherwise.
      if (juxtaposed && left->kind == Kind::divide && right->name != "rad" && right->name != "m")
        cursor_.warning_at(span, "product-after-division", "this is read as the quotient times the last factor").hint =
            "write parentheses, as in '0.01 / (2.0 PI)' or '(0.01 / 2.0) * PI'";
      left = operation(kind, span, std::move(left), std::move(right), juxtaposed);
    }
  }

  ExpressionPtr unary(bool& ends_in_number) {
    if (!cursor_.at("-") && !cursor_.at("+")) {
      ends_in_number = cursor_.peek().kind == Token::Kind::number;
      return primary();
    }
    const Token sign = cursor_.take();
    enter(sign.span);
    ExpressionPtr operand = unary(ends_in_number);
    --depth_;
    if (sign.text == "+") return operand;
    const Span span{sign.span.begin, operand->span.end};
    if (operand->kind == Kind::number) return literal(span, -operand->number);
    return operation(Kind::negate, span, std::move(operand));
  }

  ExpressionPtr primary() {
    if (cursor_.peek().kind == Token::Kind::number) {
      const Token token = cursor_.take();
      return literal(token.span, number_of(token));
    }
    if (cursor_.at("(")) return parenthesised();
    if (ExpressionPtr value = parse_named_value(cursor_)) return value;
    if (cursor_.at_name()) return name_or_function();
    missing_operand();
  }

  // Reports a missing operand. A keyword in its place is skipped, with those after it in `Ix = Iy = Iz = 0.3`, because
  // it does not begin an item.
  [[noreturn]] void missing_operand() {
    if (!cursor_.at_keyword() || cursor_.after_line_end() || cursor_.is_faulty_here())
      cursor_.unexpected(
          "a number, a name or '('",
          cursor_.at_begin() ? std::string() : fmt::format("after '{}'", cursor_.previous().text));
    const Token keyword = cursor_.peek();
    Diagnostic& d = cursor_.error(
        "unexpected-token", fmt::format("expected a number, a name or '(', found the keyword '{}'", keyword.text));
    if (cursor_.at("=", 1)) {
      d.hint = "give each item its own value";
    } else {
      d.hint = "a keyword has no value: write a number or a parameter";
      cursor_.take();
    }
    while (cursor_.at_keyword() && cursor_.at("=", 1) && !cursor_.after_line_end()) {
      cursor_.take();
      cursor_.take();
      if (!cursor_.at_keyword()) break;
    }
    throw SyntaxError{};
  }

  // The span is that of the expression in the parentheses.
  ExpressionPtr parenthesised() {
    enter(cursor_.take().span);
    ExpressionPtr inner = sum();
    --depth_;
    cursor_.expect(")", "after an expression");
    return inner;
  }

  ExpressionPtr name_or_function() {
    const Token token = cursor_.take();
    if (cursor_.at("(") && !token.escaped) return function(token);
    if (is_function(token) && cursor_.peek().kind == Token::Kind::number && !cursor_.after_line_end())
      cursor_.unexpected("'('", fmt::format("after '{}'", token.text));
    Expression e;
    const std::string lower_case = lower(token.text);
    e.kind = !token.escaped && lower_case == "pi" ? Kind::pi : Kind::name;
    e.span = token.span;
    e.name = token.text;
    e.escaped = token.escaped;
    if (accept_default(cursor_, e)) {
      e.kind = Kind::name;
    } else if (!token.escaped && (lower_case == "nan" || lower_case == "inf" || lower_case == "infinity")) {
      cursor_.error_at(token.span, "not-a-number", fmt::format("'{}' is not a finite number", token.text)).hint =
          fmt::format("write '^{}' for a parameter of this name", token.text);
      throw SyntaxError{};
    }
    return std::make_shared<const Expression>(std::move(e));
  }

  static auto find_function(const Token& name) {
    return std::find_if(
        kFunctions.begin(), kFunctions.end(), [&](const auto& function) { return name.text == function.first; });
  }

  static bool is_function(const Token& name) { return !name.escaped && find_function(name) != kFunctions.end(); }

  ExpressionPtr function(const Token& name) {
    const auto known = find_function(name);
    if (known == kFunctions.end()) {
      cursor_.error_at(name.span, "unknown-function", fmt::format("unknown function '{}'", name.text)).hint =
          "the functions are sin, cos, tan and sqrt";
      throw SyntaxError{};
    }
    ExpressionPtr argument = parenthesised();
    const Span span{name.span.begin, cursor_.previous().span.end};
    return operation(known->second, span, std::move(argument));
  }

  void enter(Span span) {
    if (++depth_ <= kMaxDepth) return;
    cursor_.error_at(
        span, "nesting-too-deep", fmt::format("this expression is nested more than {} levels deep", kMaxDepth));
    throw SyntaxError{};
  }

  // Limits the depth of the tree, which a long chain of operations makes deep.
  void count_operation() {
    if (++operations_ <= kMaxOperations) return;
    cursor_.error("expression-too-long", fmt::format("this expression has more than {} operations", kMaxOperations));
    throw SyntaxError{};
  }
};

}  // namespace

ExpressionPtr parse_expression(Cursor& cursor) {
  return ExpressionParser(cursor).run();
}

}  // namespace robcogen::language
