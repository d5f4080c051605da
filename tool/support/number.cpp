#include "support/number.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string_view>
#include <utility>

namespace robcogen {
namespace {

using Wide = __int128;

constexpr Wide kLimit = INT64_MAX;

// A fraction in lowest terms; nullopt if it does not fit.
std::optional<Rational> fitted(Wide num, Wide den) {
  if (num > kLimit || num < -kLimit || den > kLimit) return std::nullopt;
  return Rational{static_cast<std::int64_t>(num), static_cast<std::int64_t>(den)};
}

// The fraction reduced to lowest terms; nullopt if it does not fit.
std::optional<Rational> reduced(Wide num, Wide den) {
  if (den == 0) return std::nullopt;
  if (den < 0) {
    num = -num;
    den = -den;
  }
  Wide a = num < 0 ? -num : num, b = den;
  while (b != 0 && (a > kLimit || b > kLimit)) a = std::exchange(b, a % b);
  // Most numbers fit into words, whose division is much faster.
  if (b != 0) a = std::gcd(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b));
  if (a > 1) {
    num /= a;
    den /= a;
  }
  return fitted(num, den);
}

// The sum of fractions in lowest terms, by gcds of words alone (Knuth, The Art of Computer Programming 2, sec. 4.5.1);
// nullopt if the result does not fit.
std::optional<Rational> sum_of(const Rational& a, const Rational& b) {
  const std::int64_t shared = std::gcd(a.den, b.den);
  const Wide num = Wide(a.num) * (b.den / shared) + Wide(b.num) * (a.den / shared);
  const std::int64_t rest = std::gcd(static_cast<std::int64_t>(num % shared), shared);
  return fitted(num / rest, Wide(a.den / shared) * (b.den / rest));
}

std::optional<Rational> product_of(const Rational& a, const Rational& b) {
  const std::int64_t first = std::gcd(a.num, b.den), second = std::gcd(b.num, a.den);
  return fitted(Wide(a.num / first) * (b.num / second), Wide(a.den / second) * (b.den / first));
}

// num / den rounded to the nearest double, ties to even. A quotient of at least 64 bits is rounded once; its last bit
// tells whether more bits would follow.
double nearest_double(const Rational& r) {
  using Bits = unsigned __int128;
  if (r.num == 0) return 0.0;
  // If both parts are exact as doubles, the division rounds once.
  constexpr std::int64_t kExact = std::int64_t{1} << 53;
  if (r.num <= kExact && r.num >= -kExact && r.den <= kExact)
    return static_cast<double>(r.num) / static_cast<double>(r.den);
  const auto magnitude = static_cast<std::uint64_t>(r.num < 0 ? -r.num : r.num);
  const auto den = static_cast<Bits>(r.den);
  const int shift = 127 - static_cast<int>(std::bit_width(magnitude));
  const Bits shifted = static_cast<Bits>(magnitude) << shift;
  const Bits quotient = shifted / den | (shifted % den == 0 ? 0U : 1U);
  const double value = std::ldexp(static_cast<double>(quotient), -shift);
  return r.num < 0 ? -value : value;
}

double nearest_double_times_pi(const Rational& r) {
  const long double quotient = static_cast<long double>(r.num) / static_cast<long double>(r.den);
  return static_cast<double>(quotient * std::numbers::pi_v<long double>);
}

// A double that is a multiple of a small power of two is exactly that fraction.
std::optional<Rational> dyadic(double value) {
  constexpr int kBits = 20;
  constexpr double kScale = 1 << kBits;
  const double scaled = value * kScale;
  if (!(std::abs(scaled) <= 9e15)) return std::nullopt;
  const auto num = static_cast<std::int64_t>(scaled);
  if (static_cast<double>(num) != scaled) return std::nullopt;
  const int shared = num == 0 ? kBits : std::min(kBits, std::countr_zero(static_cast<std::uint64_t>(num)));
  return Rational{num / (std::int64_t{1} << shared), std::int64_t{1} << (kBits - shared)};
}

// The integer that follows the 'e' of a literal, with or without a sign; nullopt if it is too large.
std::optional<long> exponent_of(std::string_view digits) {
  if (digits.starts_with('+')) digits.remove_prefix(1);
  long exponent = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  return read.ec == std::errc() ? std::optional(exponent) : std::nullopt;
}

// The shortest decimal fraction whose nearest double this is, which is the literal that its author wrote.
std::optional<Rational> shortest_decimal(double value) {
  char buffer[40];
  const auto written = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
  const std::string_view text(buffer, static_cast<std::size_t>(written.ptr - buffer));
  const std::size_t mark = text.find('e');
  long exponent = *exponent_of(text.substr(mark + 1));
  Wide num = 0, den = 1;
  bool is_fraction = false;
  for (char c : text.substr(0, mark)) {
    if (c == '.') is_fraction = true;
    if (c < '0' || c > '9') continue;
    num = num * 10 + (c - '0');
    if (is_fraction) --exponent;
  }
  constexpr long kMaxDigits = 18;  // of an integer of 64 bits; num has at most 17
  if (exponent < -kMaxDigits || exponent > kMaxDigits) return std::nullopt;
  for (; exponent < 0; ++exponent) den *= 10;
  for (; exponent > 0; --exponent) num *= 10;
  return reduced(value < 0.0 ? -num : num, den);
}

// Whether an unsigned literal outside the range of doubles is too small rather than too large.
bool is_tiny(std::string_view text) {
  const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min(text.find('.'), mark);
  const std::size_t first = text.find_first_of("123456789");
  const std::string_view power = text.substr(std::min(mark + 1, text.size()));
  const std::optional<long> exponent = power.empty() ? 0 : exponent_of(power);
  if (!exponent) return power.front() == '-';
  return static_cast<long>(point) - static_cast<long>(first) + *exponent < 0;
}

// sin(num / den * PI), exact if it is rational; otherwise computed by octant, so that equal magnitudes are equal
// doubles.
double sin_of_pi(Wide num, Wide den) {
  num %= 2 * den;  // modulo 2 PI
  double sign = 1.0;
  if (num < 0) {
    num = -num;
    sign = -sign;
  }
  if (num >= den) {
    num -= den;
    sign = -sign;
  }
  if (2 * num > den) num = den - num;  // now 0 <= num / den <= 1/2
  if (num == 0) return 0.0;
  if (2 * num == den) return sign;
  if (6 * num == den) return sign * 0.5;
  if (4 * num == den) return sign * std::numbers::sqrt2 / 2.0;
  const long double x = static_cast<long double>(num) / static_cast<long double>(den);
  constexpr long double kPi = std::numbers::pi_v<long double>;
  return sign * static_cast<double>(4 * num < den ? std::sin(x * kPi) : std::cos((0.5L - x) * kPi));
}

}  // namespace

Number::Number(double value) : value_(value), ratio_(dyadic(value)) {
  if (value == 0.0) value_ = 0.0;  // no negative zero
}

Number Number::rational(std::int64_t num, std::int64_t den) {
  assert(den != 0);
  const std::optional<Rational> ratio = reduced(num, den);
  return ratio ? exact(*ratio, false) : Number(static_cast<double>(num) / static_cast<double>(den));
}

Number Number::pi_multiple(std::int64_t num, std::int64_t den) {
  assert(den != 0);
  if (const std::optional<Rational> ratio = reduced(num, den)) return exact(*ratio, true);
  Number n(static_cast<double>(num) / static_cast<double>(den));
  n.value_ *= std::numbers::pi;
  return n;
}

Number Number::exact(const Rational& ratio, bool times_pi) {
  Number n;
  n.ratio_ = ratio;
  n.times_pi_ = times_pi && ratio.num != 0;
  n.value_ = n.times_pi_ ? nearest_double_times_pi(ratio) : nearest_double(ratio);
  return n;
}

std::optional<Number> Number::parse(const std::string& literal) {
  const bool positive = literal.starts_with('+');
  const std::string_view text = std::string_view(literal).substr(positive ? 1 : 0);
  const std::size_t first = !positive && text.starts_with('-') ? 1 : 0;
  // from_chars also reads `inf` and `nan`.
  if (text.size() <= first || text.find_first_of(".0123456789", first) != first) return std::nullopt;
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  if (fault == std::errc::result_out_of_range && is_tiny(text.substr(first))) return Number();
  if (fault != std::errc()) return std::nullopt;
  Number n(value);
  if (!n.ratio_) n.ratio_ = shortest_decimal(value);
  return n;
}

Number operator-(const Number& a) {
  Number n = a;
  n.value_ = a.value_ == 0.0 ? 0.0 : -a.value_;
  if (n.ratio_) n.ratio_->num = -n.ratio_->num;
  return n;
}

Number operator+(const Number& a, const Number& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  Number n(a.value_ + b.value_);
  if (!a.ratio_ || !b.ratio_ || a.times_pi_ != b.times_pi_) return n;
  if (const auto sum = sum_of(*a.ratio_, *b.ratio_)) return Number::exact(*sum, a.times_pi_);
  return n;
}

Number operator-(const Number& a, const Number& b) {
  return a + (-b);
}

Number operator*(const Number& a, const Number& b) {
  if (a.is_zero() || b.is_zero()) return Number();
  Number n(a.value_ * b.value_);
  if (!a.ratio_ || !b.ratio_ || (a.times_pi_ && b.times_pi_)) return n;
  const auto product = product_of(*a.ratio_, *b.ratio_);
  if (!product) return n;
  return Number::exact(*product, a.times_pi_ || b.times_pi_);
}

Number operator/(const Number& a, const Number& b) {
  Number n(a.value_ / b.value_);
  if (!a.ratio_ || !b.ratio_ || b.is_zero()) return n;
  if (b.times_pi_ && !a.times_pi_) return n;
  const auto quotient = reduced(Wide(a.ratio_->num) * b.ratio_->den, Wide(a.ratio_->den) * b.ratio_->num);
  if (!quotient) return n;
  return Number::exact(*quotient, a.times_pi_ && !b.times_pi_);
}

Number sin(const Number& a) {
  return a.is_pi_multiple() ? Number(sin_of_pi(a.ratio_->num, a.ratio_->den)) : Number(std::sin(a.value_));
}

// cos(x) = sin(x + PI/2), and the shift is exact.
Number cos(const Number& a) {
  if (!a.is_pi_multiple()) return Number(std::cos(a.value_));
  return Number(sin_of_pi(2 * Wide(a.ratio_->num) + a.ratio_->den, 2 * Wide(a.ratio_->den)));
}

Number tan(const Number& a) {
  if (!a.is_pi_multiple()) return Number(std::tan(a.value_));
  const double s = sin(a).value(), c = cos(a).value();
  return Number(s == c ? 1.0 : s == -c ? -1.0 : s / c);
}

Number sqrt(const Number& a) {
  const double root = std::sqrt(a.value_);
  Number n(root);
  if (!a.ratio_ || a.times_pi_ || a.value_ < 0.0) return n;
  const auto num = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<long double>(a.ratio_->num))));
  const auto den = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<long double>(a.ratio_->den))));
  if (Wide(num) * num == a.ratio_->num && Wide(den) * den == a.ratio_->den) return Number::rational(num, den);
  return n;
}

bool operator==(const Number& a, const Number& b) {
  return a.value_ == b.value_ && a.ratio_ == b.ratio_ && a.times_pi_ == b.times_pi_;
}

std::string print(const Number& n) {
  constexpr std::int64_t kMaxLiteral = std::int64_t{1} << 53;  // doubles hold every integer up to here
  const auto [num, den] = n.ratio().value_or(Rational{INT64_MAX, 1});
  if (num > kMaxLiteral || num < -kMaxLiteral || den > kMaxLiteral) return print_double(n.value());
  if (!n.is_pi_multiple()) {
    const std::string plain = print_double(n.value());
    if (Number::parse(plain) == n) return plain;
  }
  const std::string divisor = den == 1 ? "" : "/" + std::to_string(den) + ".0";
  const std::string factor = std::to_string(num) + ".0";
  if (!n.is_pi_multiple()) return factor + divisor;
  if (num == 1 || num == -1) return (num < 0 ? "-PI" : "PI") + divisor;
  return factor + " PI" + divisor;
}

namespace {

template <class Real>
std::string print_real(Real value) {
  if (value == Real(0)) return "0.0";
  char buffer[40];
  const auto [end, fault] = std::to_chars(buffer, buffer + sizeof buffer, value);
  std::string text(buffer, fault == std::errc() ? end : buffer);
  const bool plain = text.find_first_of(".eEni") == std::string::npos;
  return plain ? text + ".0" : text;
}

}  // namespace

std::string print_double(double value) {
  return print_real(value);
}

std::string print_float(float value) {
  return print_real(value);
}

}  // namespace robcogen
