#include "support/number.h"

#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace robcogen {
namespace {

using Wide = __int128;

// Reduced to lowest terms; nullopt when it does not fit.
std::optional<Rational> reduced(Wide num, Wide den) {
  if (den == 0) return std::nullopt;
  if (den < 0) {
    num = -num;
    den = -den;
  }
  Wide a = num < 0 ? -num : num, b = den;
  while (b != 0) a = std::exchange(b, a % b);
  if (a > 1) {
    num /= a;
    den /= a;
  }
  constexpr Wide limit = INT64_MAX;
  if (num > limit || num < -limit || den > limit) return std::nullopt;
  return Rational{static_cast<std::int64_t>(num), static_cast<std::int64_t>(den)};
}

// Correctly rounded when both parts fit a long double's 64-bit significand, which they do.
double value_of(const Rational& r, bool times_pi) {
  const long double quotient = static_cast<long double>(r.num) / static_cast<long double>(r.den);
  return static_cast<double>(times_pi ? quotient * std::numbers::pi_v<long double> : quotient);
}

// A double that is a fraction of a small power of two is taken at its word.
std::optional<Rational> dyadic(double value) {
  constexpr double kScale = 1 << 20;
  const double scaled = value * kScale;
  if (std::abs(scaled) > 9e15 || scaled != std::floor(scaled)) return std::nullopt;
  return reduced(static_cast<std::int64_t>(scaled), static_cast<std::int64_t>(kScale));
}

// sin(r PI), exact where it is rational; otherwise by the octant, so that equal magnitudes are equal doubles.
double sin_of_pi(Rational r) {
  std::int64_t num = r.num % (2 * r.den);  // 2 PI has no part in it
  double sign = 1.0;
  if (num < 0) {
    num = -num;
    sign = -sign;
  }
  if (num >= r.den) {
    num -= r.den;
    sign = -sign;
  }
  if (2 * num > r.den) num = r.den - num;  // now 0 <= num / den <= 1/2
  if (num == 0) return 0.0;
  if (2 * num == r.den) return sign;
  if (6 * num == r.den) return sign * 0.5;
  const long double quarter = 0.25L, x = static_cast<long double>(num) / static_cast<long double>(r.den);
  constexpr long double pi = std::numbers::pi_v<long double>;
  const long double s = x <= quarter ? std::sin(x * pi) : std::cos((0.5L - x) * pi);
  return sign * static_cast<double>(4 * num == r.den ? std::sqrt(0.5L) : s);
}

}  // namespace

Number::Number(double value) : value_(value), ratio_(dyadic(value)) {
  if (ratio_ && value == 0.0) value_ = 0.0;  // no negative zero
}

Number Number::rational(std::int64_t num, std::int64_t den) {
  Number n;
  n.ratio_ = reduced(num, den);
  if (!n.ratio_) throw std::logic_error("a rational number with denominator zero");
  n.value_ = value_of(*n.ratio_, false);
  return n;
}

Number Number::pi_multiple(std::int64_t num, std::int64_t den) {
  Number n = rational(num, den);
  if (num == 0) return n;
  n.times_pi_ = true;
  n.value_ = value_of(*n.ratio_, true);
  return n;
}

std::optional<Number> Number::parse(const std::string& literal) {
  const std::string text = literal.starts_with('+') ? literal.substr(1) : literal;
  for (char c : text)
    if (c != '.' && c != '-' && c != '+' && c != 'e' && c != 'E' && (c < '0' || c > '9')) return std::nullopt;
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool tiny = fault == std::errc::result_out_of_range && std::abs(value) < 1.0;
  if ((fault != std::errc() && !tiny) || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  Number n(value);
  if (n.ratio_) return n;

  // Decimal digits and a power of ten, as long as they fit.
  std::int64_t digits = 0, scale = 1;
  bool point = false;
  for (char c : text) {
    if (c == '-') continue;
    if (c == '.') {
      point = true;
      continue;
    }
    if (c < '0' || c > '9' || digits > INT64_MAX / 16 || scale > INT64_MAX / 16) return n;
    digits = digits * 10 + (c - '0');
    if (point) scale *= 10;
  }
  n.ratio_ = reduced(text.starts_with('-') ? -digits : digits, scale);
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
  const Wide left = Wide(a.ratio_->num) * b.ratio_->den, right = Wide(b.ratio_->num) * a.ratio_->den;
  if (const auto sum = reduced(left + right, Wide(a.ratio_->den) * b.ratio_->den))
    return a.times_pi_ ? Number::pi_multiple(sum->num, sum->den) : Number::rational(sum->num, sum->den);
  return n;
}

Number operator-(const Number& a, const Number& b) {
  return a + (-b);
}

Number operator*(const Number& a, const Number& b) {
  if (a.is_zero() || b.is_zero()) return Number();
  Number n(a.value_ * b.value_);
  if (!a.ratio_ || !b.ratio_ || (a.times_pi_ && b.times_pi_)) return n;
  const auto product = reduced(Wide(a.ratio_->num) * b.ratio_->num, Wide(a.ratio_->den) * b.ratio_->den);
  if (!product) return n;
  return a.times_pi_ || b.times_pi_ ? Number::pi_multiple(product->num, product->den)
                                    : Number::rational(product->num, product->den);
}

Number operator/(const Number& a, const Number& b) {
  Number n(a.value_ / b.value_);
  if (!a.ratio_ || !b.ratio_ || b.is_zero()) return n;
  if (b.times_pi_ && !a.times_pi_) return n;
  const auto quotient = reduced(Wide(a.ratio_->num) * b.ratio_->den, Wide(a.ratio_->den) * b.ratio_->num);
  if (!quotient) return n;
  return a.times_pi_ && !b.times_pi_ ? Number::pi_multiple(quotient->num, quotient->den)
                                     : Number::rational(quotient->num, quotient->den);
}

Number sin(const Number& a) {
  return a.is_pi_multiple() ? Number(sin_of_pi(*a.ratio_)) : Number(std::sin(a.value_));
}

// cos(x) = sin(x + PI/2), and the shift is exact.
Number cos(const Number& a) {
  if (!a.is_pi_multiple()) return Number(std::cos(a.value_));
  const auto shifted = reduced(Wide(a.ratio_->num) * 2 + a.ratio_->den, Wide(a.ratio_->den) * 2);
  return shifted ? Number(sin_of_pi(*shifted)) : Number(std::cos(a.value_));
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
  if (!n.is_pi_multiple()) return print_double(n.value());
  const auto& [num, den] = *n.ratio();
  const std::string sign = num < 0 ? "-" : "";
  const std::int64_t magnitude = num < 0 ? -num : num;
  const std::string divisor = den == 1 ? "" : "/" + std::to_string(den) + ".0";
  if (magnitude == 1) return sign + "PI" + divisor;
  return sign + std::to_string(magnitude) + ".0 PI" + divisor;
}

std::string print_double(double value) {
  if (value == 0.0) return "0.0";
  char buffer[40];
  const auto [end, fault] = std::to_chars(buffer, buffer + sizeof buffer, value);
  std::string text(buffer, fault == std::errc() ? end : buffer);
  const bool plain = text.find_first_of(".eEni") == std::string::npos;
  return plain ? text + ".0" : text;
}

}  // namespace robcogen
