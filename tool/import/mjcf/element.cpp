#include "import/mjcf/element.h"

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

}  // namespace robcogen::import::from_mjcf
