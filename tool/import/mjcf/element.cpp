#include "import/mjcf/element.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace robcogen::import::from_mjcf {

bool is_orientation(const Attribute& attribute) {
  constexpr std::array kNames = {"quat", "axisangle", "euler", "xyaxes", "zaxis"};
  return std::find(kNames.begin(), kNames.end(), attribute.name) != kNames.end();
}

bool has_orientation(const Element& element) {
  return std::any_of(element.attributes.begin(), element.attributes.end(), is_orientation);
}

bool has_nonzero(const Attribute& attribute, Diagnostics& diagnostics) {
  const std::vector<Number> n = Values(diagnostics).numbers(attribute, 1, 3);
  return std::any_of(n.begin(), n.end(), [](const Number& x) { return !x.is_zero(); });
}

Number linear_coefficient(const Element& element, const char* attribute, Diagnostics& diagnostics) {
  const Attribute* found = find(element, attribute);
  if (found == nullptr) return {};
  const std::vector<Number> n = Values(diagnostics).numbers(*found, 1, 3);
  if (!std::all_of(n.begin() + 1, n.end(), [](const Number& x) { return x.is_zero(); }))
    diagnostics
        .error(
            "unsupported-attribute", found->place,
            fmt::format("this '{}' is a polynomial, which is not supported", attribute))
        .hint = "write one number, for a linear force";
  return n[0];
}

}  // namespace robcogen::import::from_mjcf
