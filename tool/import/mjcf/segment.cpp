#include "import/mjcf/segment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace robcogen::import::from_mjcf {

namespace {

bool all_zero(const std::array<Number, 3>& n) {
  return std::all_of(n.begin(), n.end(), [](const Number& x) { return x.is_zero(); });
}

}  // namespace

std::optional<Segment> read_segment(const Element& element, const std::string& shape, Diagnostics& diagnostics) {
  const Attribute* ends = find(element, "fromto");
  if (ends == nullptr) return std::nullopt;
  const std::vector<std::string> kShapes = {"capsule", "cylinder", "box", "ellipsoid"};
  if (std::find(kShapes.begin(), kShapes.end(), shape) == kShapes.end()) {
    diagnostics
        .error(
            "fromto-of-shape", ends->place,
            fmt::format("this '{}' has the type '{}', which has no 'fromto'", element.name, shape))
        .hint = "write type=\"capsule\", \"cylinder\", \"box\" or \"ellipsoid\"";
    return std::nullopt;
  }
  Values values(diagnostics);
  if (!all_zero(values.triple(element, "pos", {})))
    diagnostics
        .error(
            "two-positions", find(element, "pos")->place,
            fmt::format("this '{}' has both 'pos' and 'fromto'", element.name))
        .notes.push_back({ends->place, "the 'fromto' is here"});

  Segment result;
  const std::optional<std::vector<Number>> given = values.read(*ends, 6, 6);
  if (!given) return result;
  const std::vector<Number>& n = *given;
  const std::array<Number, 3> along = {n[0] - n[3], n[1] - n[4], n[2] - n[5]};
  if (all_zero(along)) {
    diagnostics.error("no-direction", ends->place, "this 'fromto' gives no direction");
    return result;
  }
  for (std::size_t i = 0; i < 3; ++i) result.middle[i] = quantity(Number::rational(1, 2) * (n[i] + n[i + 3]));
  result.along = along;
  result.length = std::hypot(along[0].value(), along[1].value(), along[2].value());
  return result;
}

}  // namespace robcogen::import::from_mjcf
