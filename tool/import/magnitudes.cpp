#include "import/magnitudes.h"

#include <fmt/format.h>

#include "support/number.h"

namespace robcogen::import {

std::string too_large(std::string_view what) {
  return fmt::format(
      "{} is too large: a quantity of a robot must be below {} in SI units", what, print_double(kTooLarge));
}

}  // namespace robcogen::import
