// Exact arithmetic of document constants, compared with plain integer arithmetic, strtod and libm.
#include "support/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>

namespace robcogen::number_test {
namespace {

constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();

Number parse(const std::string& literal) {
  const std::optional<Number> number = Number::parse(literal);
  EXPECT_TRUE(number.has_value()) << literal;
  return number.value_or(Number(std::nan("")));
}

TEST(Number, IsInLowestTermsWithPositiveDenominator) {
  EXPECT_EQ(Number::rational(6, -4).ratio(), (Rational{-3, 2}));
  EXPECT_EQ(Number::rational(0, -7).ratio(), (Rational{0, 1}));
  EXPECT_EQ(Number::pi_multiple(2, 8).ratio(), (Rational{1, 4}));
  EXPECT_FALSE(Number::pi_multiple(0, 8).is_pi_multiple());
  EXPECT_EQ(Number::pi_multiple(1).value(), std::numbers::pi);
  EXPECT_EQ(Number::pi_multiple(-3, 2).value(), -1.5 * std::numbers::pi);
}

// strtod rounds correctly. Rounding a quotient to 64 bits and then to 53 differs in one of 2,000 cases.
TEST(Number, HasTheNearestDouble) {
  constexpr std::uint64_t kSeed = 41;
  std::mt19937_64 engine(kSeed);
  for (int round = 0; round < 50000; ++round) {
    const auto num = static_cast<std::int64_t>(engine() >> (1 + engine() % 40));
    const int power = static_cast<int>(engine() % 19);
    std::int64_t den = 1;
    for (int i = 0; i < power; ++i) den *= 10;
    const std::string literal = std::to_string(num) + "e-" + std::to_string(power);
    const double expected = std::strtod(literal.c_str(), nullptr);
    ASSERT_EQ(Number::rational(num, den).value(), expected) << "seed " << kSeed << ", " << literal;
    ASSERT_EQ(Number::rational(num, -den).value(), -expected) << "seed " << kSeed << ", " << literal;
  }
  const std::int64_t halfway = (std::int64_t{1} << 53) + 1;
  EXPECT_EQ(Number::rational(halfway).value(), 9007199254740992.0);
  EXPECT_EQ(Number::rational(kLargest).value(), 9223372036854775808.0);
}

TEST(Number, ReadsLiteralsAsStrtodDoes) {
  for (const char* literal :
       {"1", "1.", ".5", "-.5", "+0.5", "0.1", "1e-3", "1.0E5", "3.14159265358979323846", "-0.000001", "1e308",
        "5e-324", "123456789012345678901234567890", "0.30000000000000004", "1.7976931348623157e308", "00012.50",
        "2.2250738585072011e-308", "9007199254740993", "1E+2"}) {
    EXPECT_EQ(parse(literal).value(), std::strtod(literal, nullptr)) << literal;
  }
}

TEST(Number, RefusesWhatIsNoLiteral) {
  for (const char* text : {"",     "-",        "+",   ".",     "-.", "e5", "1e",  "1e+", "0x10", "nan", "NaN", "inf",
                           "-inf", "infinity", "1,5", "1.2.3", " 1", "1 ", "--1", "+-1", "-+1",  "1a",  "1e5x"}) {
    EXPECT_FALSE(Number::parse(text).has_value()) << text;
  }
}

TEST(Number, RefusesWhatIsTooLargeAndTakesTheTinyForZero) {
  const std::string zeros(400, '0');
  for (const std::string& text :
       {std::string("1e999"), std::string("-1e999"), std::string("1.8e308"), "1" + zeros, "1" + zeros + "e-10",
        std::string("1e99999999999999999999")})
    EXPECT_FALSE(Number::parse(text).has_value()) << text;
  for (const std::string& text :
       {std::string("1e-999"), std::string("-1e-999"), "0." + zeros + "1", "." + zeros + "1e5",
        std::string("1e-99999999999999999999")}) {
    EXPECT_EQ(parse(text), Number()) << text;
  }
  EXPECT_EQ(parse("0e999"), Number());
  EXPECT_EQ(parse("1" + zeros + "e-400").value(), 1.0);
}

TEST(Number, IsExactWhereTheShortestDecimalFits) {
  EXPECT_EQ(parse("0.1").ratio(), (Rational{1, 10}));
  EXPECT_EQ(parse("-0.35").ratio(), (Rational{-7, 20}));
  EXPECT_EQ(parse("1e-3").ratio(), (Rational{1, 1000}));
  EXPECT_EQ(parse("1.5e3").ratio(), (Rational{1500, 1}));
  EXPECT_EQ(parse("1e-30").ratio(), std::nullopt);
  EXPECT_EQ(parse("1e30").ratio(), std::nullopt);
}

TEST(Number, IsOneForLiteralsOfOneDouble) {
  EXPECT_EQ(parse("3.14159265358979323846"), parse("3.141592653589793"));
  EXPECT_EQ(parse("0.10000000000000000555"), parse("0.1"));
  EXPECT_EQ(parse("-0.0"), Number());
  EXPECT_FALSE(std::signbit(parse("-0.0").value()));
  EXPECT_FALSE(std::signbit((-Number()).value()));
}

TEST(Number, AddsAndMultipliesExactly) {
  EXPECT_EQ(parse("0.1") + parse("0.2"), parse("0.3"));  // 0.30000000000000004 in doubles
  EXPECT_EQ(parse("0.1") * Number::rational(10), Number::rational(1));
  EXPECT_EQ(Number::rational(1) / Number::rational(3) + Number::rational(2, 3), Number::rational(1));
  EXPECT_EQ(parse("0.3") - parse("0.3"), Number());
  EXPECT_EQ(Number::pi_multiple(1, 3) + Number::pi_multiple(1, 6), Number::pi_multiple(1, 2));
  EXPECT_EQ(Number::pi_multiple(1, 2) - Number::pi_multiple(1, 2), Number());
  EXPECT_EQ(Number::rational(2) * Number::pi_multiple(1, 4), Number::pi_multiple(1, 2));
  EXPECT_EQ(Number::pi_multiple(1) / Number::rational(-2), Number::pi_multiple(-1, 2));
  EXPECT_EQ(Number::pi_multiple(1) / Number::pi_multiple(2), Number::rational(1, 2));
  EXPECT_EQ(Number() / Number::pi_multiple(1), Number());
}

TEST(Number, FallsBackToDoublesWhereNothingExactIsKnown) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_EQ((Number::pi_multiple(1) + Number::rational(1)).value(), kPi + 1.0);
  EXPECT_EQ((Number::pi_multiple(1) + Number::rational(1)).ratio(), std::nullopt);
  EXPECT_EQ((Number::pi_multiple(1) * Number::pi_multiple(1)).value(), kPi * kPi);
  EXPECT_EQ((Number::rational(1) / Number::pi_multiple(1)).value(), 1.0 / kPi);
  const Number tiny = Number::rational(1, kLargest);
  EXPECT_EQ((tiny * tiny).ratio(), std::nullopt);
  EXPECT_EQ((tiny * tiny).value(), tiny.value() * tiny.value());
  EXPECT_EQ((tiny + Number::rational(1, kLargest - 1)).ratio(), std::nullopt);
  const Number large = Number::rational(kLargest);
  EXPECT_EQ((large + large).value(), 2.0 * large.value());
  EXPECT_EQ(Number::rational(std::numeric_limits<std::int64_t>::min()).value(), -9223372036854775808.0);
  EXPECT_TRUE(std::isinf((Number::rational(1) / Number()).value()));
  EXPECT_TRUE(std::isnan((Number() / Number()).value()));
}

// Random sums, products and quotients of small fractions, compared with integer arithmetic.
TEST(Number, AgreesWithIntegerArithmetic) {
  constexpr std::uint64_t kSeed = 7;
  std::mt19937_64 engine(kSeed);
  const auto pick = [&](int most) {
    return static_cast<std::int64_t>(engine() % (2 * std::uint64_t(most) + 1)) - most;
  };
  for (int round = 0; round < 2000; ++round) {
    const std::int64_t a = pick(1000), b = 1 + std::abs(pick(1000)), c = pick(1000), d = 1 + std::abs(pick(1000));
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(round));
    const Number x = Number::rational(a, b), y = Number::rational(c, d);
    EXPECT_EQ(x + y, Number::rational(a * d + c * b, b * d));
    EXPECT_EQ(x - y, Number::rational(a * d - c * b, b * d));
    EXPECT_EQ(x * y, Number::rational(a * c, b * d));
    if (c != 0) {
      EXPECT_EQ(x / y, Number::rational(a * d, b * c));
    }
  }
}

TEST(Number, HasExactTrigonometryOfMultiplesOfPi) {
  const auto expect = [](std::int64_t num, std::int64_t den, double sine, double cosine) {
    const Number angle = Number::pi_multiple(num, den);
    EXPECT_EQ(sin(angle).value(), sine) << num << " PI / " << den;
    EXPECT_EQ(cos(angle).value(), cosine) << num << " PI / " << den;
    EXPECT_FALSE(std::signbit(sin(angle).value()) && sine == 0.0);
  };
  const double diagonal = std::sqrt(0.5), high = std::sqrt(3.0) / 2.0;
  expect(1, 1, 0.0, -1.0);
  expect(-1, 1, 0.0, -1.0);
  expect(2, 1, 0.0, 1.0);
  expect(1, 2, 1.0, 0.0);
  expect(-1, 2, -1.0, 0.0);
  expect(3, 2, -1.0, 0.0);
  expect(1, 6, 0.5, high);
  expect(1, 3, high, 0.5);
  expect(2, 3, high, -0.5);
  expect(-7, 6, 0.5, -high);
  expect(1, 4, diagonal, diagonal);
  expect(3, 4, diagonal, -diagonal);
  expect(-3, 4, -diagonal, -diagonal);
  expect(1000001, 2, 1.0, 0.0);
  expect(kLargest, 1, 0.0, -1.0);
  expect(kLargest, 2, -1.0, 0.0);
  EXPECT_EQ(tan(Number::pi_multiple(1, 4)).value(), 1.0);
  EXPECT_EQ(tan(Number::pi_multiple(3, 4)).value(), -1.0);
  EXPECT_EQ(tan(Number::pi_multiple(1)).value(), 0.0);
  EXPECT_TRUE(std::isinf(tan(Number::pi_multiple(1, 2)).value()));
  EXPECT_EQ(sin(Number()), Number());
  EXPECT_EQ(cos(Number()), Number::rational(1));
}

TEST(Number, HasTheTrigonometryOfLibm) {
  constexpr double kTolerance = 4e-16;  // the rounded argument, and one rounding of the result
  for (std::int64_t den : {3, 5, 7, 12, 180}) {
    for (std::int64_t num = -2 * den; num <= 2 * den; ++num) {
      const Number angle = Number::pi_multiple(num, den);
      EXPECT_NEAR(sin(angle).value(), std::sin(angle.value()), 2 * kTolerance) << num << " PI / " << den;
      EXPECT_NEAR(cos(angle).value(), std::cos(angle.value()), 2 * kTolerance) << num << " PI / " << den;
    }
  }
  // nothing overflows at the largest denominators
  EXPECT_NEAR(sin(Number::pi_multiple(kLargest - 1, kLargest)).value(), 0.0, 1e-15);
  EXPECT_NEAR(cos(Number::pi_multiple(kLargest - 1, kLargest)).value(), -1.0, 1e-15);
  EXPECT_EQ(sin(parse("0.3")).value(), std::sin(0.3));
  EXPECT_EQ(cos(parse("0.3")).value(), std::cos(0.3));
  EXPECT_EQ(tan(parse("0.3")).value(), std::tan(0.3));
}

TEST(Number, HasExactRootsOfSquares) {
  EXPECT_EQ(sqrt(parse("0.25")), Number::rational(1, 2));
  EXPECT_EQ(sqrt(Number::rational(4, 9)), Number::rational(2, 3));
  EXPECT_EQ(sqrt(Number()), Number());
  EXPECT_EQ(sqrt(Number::rational(2)).value(), std::sqrt(2.0));
  EXPECT_EQ(sqrt(Number::rational(3037000499 * 3037000499LL)), Number::rational(3037000499));
  EXPECT_EQ(sqrt(Number::pi_multiple(4)).value(), std::sqrt(4.0 * std::numbers::pi));
  EXPECT_TRUE(std::isnan(sqrt(Number::rational(-1)).value()));
}

TEST(Number, PrintsAsDocumentsSpellIt) {
  EXPECT_EQ(print(parse("0.25")), "0.25");
  EXPECT_EQ(print(Number::rational(-3)), "-3.0");
  EXPECT_EQ(print(Number::rational(1, 3)), "1.0/3.0");
  EXPECT_EQ(print(Number::pi_multiple(1)), "PI");
  EXPECT_EQ(print(Number::pi_multiple(-1)), "-PI");
  EXPECT_EQ(print(Number::pi_multiple(1, 2)), "PI/2.0");
  EXPECT_EQ(print(Number::pi_multiple(-1, 2)), "-PI/2.0");
  EXPECT_EQ(print(Number::pi_multiple(2, 3)), "2.0 PI/3.0");
  EXPECT_EQ(print(Number::pi_multiple(-5)), "-5.0 PI");
  EXPECT_EQ(print(sin(parse("1.0"))), "0.8414709848078965");
  // integers that a literal cannot hold
  EXPECT_EQ(std::strtod(print(Number::rational(1, kLargest)).c_str(), nullptr), 1.0 / static_cast<double>(kLargest));
  EXPECT_EQ(
      std::strtod(print(Number::pi_multiple(1, kLargest)).c_str(), nullptr), Number::pi_multiple(1, kLargest).value());
}

TEST(Number, PrintsDoublesThatReadBack) {
  EXPECT_EQ(print_double(1.0), "1.0");
  EXPECT_EQ(print_double(-0.35), "-0.35");
  EXPECT_EQ(print_double(1e-9), "1e-09");
  EXPECT_EQ(print_double(0.0), "0.0");
  EXPECT_EQ(print_double(-0.0), "0.0");
  EXPECT_EQ(print_double(1e22), "1e+22");
  EXPECT_EQ(print_double(123456789.0), "123456789.0");
  constexpr std::uint64_t kSeed = 3;
  std::mt19937_64 engine(kSeed);
  for (int round = 0; round < 20000; ++round) {
    const double value = std::bit_cast<double>(engine());
    if (!std::isfinite(value)) continue;
    const std::string text = print_double(value);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << "seed " << kSeed << ", " << text;
    EXPECT_EQ(parse(text).value(), value) << "seed " << kSeed << ", " << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace robcogen::number_test
