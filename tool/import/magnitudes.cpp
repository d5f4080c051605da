#include "import/magnitudes.h"

#include <fmt/format.h>

#include <cmath>

#include "support/number.h"

namespace robcogen::import {

std::string too_large(std::string_view what) {
  return fmt::format(
      "{} is too large: a quantity of a robot must be below {} in SI units", what, print_double(kTooLarge));
}

std::string large_angle(double angle, double turns) {
  constexpr double kTurn = 6.2833;  // 6.2832, a full turn, is intentional
  const double size = std::abs(angle);
  if (!(size >= turns * kTurn && size <= kTooLarge)) return "";
  return fmt::format(
      "{} rad is more than {}", print_double(angle), turns > 1.0 ? fmt::format("{} turns", turns) : "a turn");
}

}  // namespace robcogen::import
