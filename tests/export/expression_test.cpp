// Quantities are printed as text and read back.
#include "export/expression.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "import/parameters.h"
#include "language/common/parse_expression.h"
#include "language/kinematics/keywords.h"
#include "patterns.h"

namespace robcogen::expression_test {
namespace {

using model::ParameterKind;
using model::Quantity;

struct Read {
  Quantity quantity;
  std::vector<model::Parameter> parameters;
  language::ExpressionPtr expression;
};

Read read(const std::string& text) {
  const auto source = std::make_shared<Source>("test", text);
  Diagnostics diagnostics;
  language::Cursor cursor(language::tokenize(source, diagnostics), language::kinematics::keywords(), diagnostics);
  Read result;
  result.expression = language::parse_expression(cursor);
  import::QuantityReader reader(source, diagnostics);
  result.quantity = reader.read(*result.expression, ParameterKind::inertial);
  result.parameters = reader.parameters();
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.render();
  return result;
}

std::string text_of(const Number& number) {
  return language::print(*exporting::expression(Quantity(number), {}));
}

TEST(ExportedExpression, SpellsNumbersAsAuthorsDo) {
  EXPECT_EQ(text_of(Number()), "0.0");
  EXPECT_EQ(text_of(Number::rational(-2)), "-2.0");
  EXPECT_EQ(text_of(*Number::parse("0.35")), "0.35");
  EXPECT_EQ(text_of(*Number::parse("-0.00001")), "-0.00001");
  EXPECT_EQ(text_of(*Number::parse("5.42101e-20")), "0.0000000000000000000542101");
  EXPECT_EQ(text_of(Number::rational(1, 8)), "0.125");
  EXPECT_EQ(text_of(Number::rational(1, 3)), "0.3333333333333333");
  EXPECT_EQ(text_of(Number::rational(-17094918, 304890005)), "-0.05606913221048358");
  EXPECT_EQ(text_of(Number::pi_multiple(1)), "PI");
  EXPECT_EQ(text_of(Number::pi_multiple(-1, 2)), "-PI/2.0");
  EXPECT_EQ(text_of(Number::pi_multiple(-2, 3)), "-PI/1.5");
  EXPECT_EQ(text_of(Number::pi_multiple(3, 4)), "0.75 PI");
  EXPECT_EQ(text_of(Number::pi_multiple(-5, 12)), "-PI/2.4");
  EXPECT_EQ(text_of(Number::pi_multiple(-3)), "-3.0 PI");
  EXPECT_EQ(text_of(Number::pi_multiple(7, 12)), "1.8325957145940461");
  EXPECT_EQ(text_of(Number(0.1 + 0.2)), "0.30000000000000004");
}

// True for numbers as the first release of the language spells them: `FLOAT`, `FLOAT PI`, `PI`, `PI/FLOAT`.
bool is_original(const std::string& text) {
  return test::whole_match(text, R"(-?\d+\.\d+( PI)?|-?PI(/\d+\.\d+)?)").has_value();
}

bool is_decimal(const Number& n) {
  return Number::parse(print_double(n.value())) == n;
}

// True for rational numbers that are decimals, and for multiples of PI by a decimal or by the inverse of one.
bool is_spelled_exactly(const Number& n) {
  if (!n.ratio() || n.is_zero()) return n.is_zero();
  const auto [num, den] = *n.ratio();
  const bool is_direct = is_decimal(Number::rational(num, den));
  if (!n.is_pi_multiple()) return is_direct;
  return is_direct || is_decimal(Number::rational(den, num < 0 ? -num : num));
}

void expect_survives(const Number& n) {
  const language::ExpressionPtr written = exporting::expression(Quantity(n), {});
  const std::string text = language::print(*written);
  EXPECT_TRUE(is_original(text)) << text;
  const Read back = read(text);
  EXPECT_TRUE(language::equal(*written, *back.expression)) << text;
  ASSERT_TRUE(back.quantity.is_constant()) << text;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(back.quantity.number().value()), std::bit_cast<std::uint64_t>(n.value()))
      << text;
  EXPECT_TRUE(back.quantity.number() == n || !is_spelled_exactly(n)) << text;
}

TEST(ExportedExpression, KeepsEveryNumber) {
  std::mt19937_64 engine(6);
  const auto whole = [&](int bits) {
    const auto magnitude = static_cast<std::int64_t>(engine() >> (64 - bits));
    return engine() % 2 == 0 ? magnitude : -magnitude;
  };
  for (int i = 0; i < 5000; ++i) {
    const int bits = 1 + i % 49;  // above 2^49, the reader finds the number too large for a robot
    const std::int64_t num = whole(bits), den = 1 + std::abs(whole(1 + i % 31));
    expect_survives(Number::rational(num, den));
    expect_survives(Number::pi_multiple(num % 100000, den));
    const double any = static_cast<double>(whole(53)) * 0x1p-53;
    expect_survives(Number(any));
    expect_survives(Number(any * std::pow(10.0, i % 60 - 45)));
    expect_survives(*Number::parse(print_double(any)));
    expect_survives(*Number::parse(std::to_string(num) + "e-" + std::to_string(i % 25)));
    expect_survives(sin(Number::pi_multiple(num, 24)));
  }
}

TEST(ExportedExpression, KeepsOperations) {
  for (const char* text :
       {"a",
        "-a",
        "2.0 a",
        "a/2.0",
        "a + b*3.0",
        "a - (b - 1.5)",
        "a - (b + 1.5)",
        "a/(b/2.0)",
        "a/(b*c)",
        "-(a + b)",
        "(a + b) * (a - b)",
        "sin(a) * cos(b) - tan(a/2.0)",
        "sqrt(a * a + 1.0)",
        "2.0 * -a",
        "a * -b",
        "a - -b",
        "m1[1.0]",
        "m1[-0.25] * m2[0.1]",
        "^mass + ^pi * ^inf",
        "PI * a",
        "PI[3.0] a",
        "1.0/3.0 * a",
        "a/-2.0"}) {
    const Read first = read(text);
    const std::string written = language::print(*exporting::expression(first.quantity, first.parameters));
    SCOPED_TRACE(std::string(text) + " became " + written);
    const Read second = read(written);
    ASSERT_EQ(second.parameters.size(), first.parameters.size());
    std::vector<double> values;
    for (std::size_t i = 0; i < first.parameters.size(); ++i) {
      EXPECT_EQ(second.parameters[i].name, first.parameters[i].name);
      EXPECT_EQ(second.parameters[i].default_value, first.parameters[i].default_value);
      values.push_back(0.7 + 0.45 * static_cast<double>(i));
    }
    EXPECT_EQ(evaluate(second.quantity, values), evaluate(first.quantity, values));
  }
}

TEST(ExportedExpression, NamesVariables) {
  EXPECT_EQ(language::print(*exporting::expression(cos(Quantity::variable(1)), {}, {"q_a", "q_b"})), "cos(q_b)");
}

}  // namespace
}  // namespace robcogen::expression_test
