#include "import/mjcf/geom_size.h"

#include <vector>

namespace robcogen::import::from_mjcf {
namespace {

// Reads the first `count` numbers of the attribute `size`.
std::array<double, 3> numbers_of(const Element& geom, std::size_t count, Diagnostics& diagnostics) {
  const Attribute* given = find(geom, "size");
  if (given == nullptr) {
    diagnostics.error("missing-attribute", geom.place, "this 'geom' has no attribute 'size'");
    return {1.0, 1.0, 1.0};
  }
  std::array<double, 3> result = {1.0, 1.0, 1.0};
  const std::optional<std::vector<Number>> n = Values(diagnostics).read(*given, count, 3);
  if (!n) return result;
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = (*n)[i].value();
    if (result[i] > 0.0) continue;
    diagnostics.error("geom-size", given->place, "the size of this geom is not positive");
    return {1.0, 1.0, 1.0};
  }
  return result;
}

}  // namespace

std::string type_of_geom(const Element& geom, Diagnostics& diagnostics) {
  static const std::vector<std::string> types = {"sphere", "capsule", "ellipsoid", "cylinder", "box",
                                                 "plane",  "hfield",  "mesh",      "sdf"};
  return types[Values(diagnostics).word(geom, "type", types, 0)];
}

GeomSize read_size(const Element& geom, const std::string& type, Diagnostics& diagnostics) {
  GeomSize result;
  result.segment = read_segment(geom, type, diagnostics);
  const bool is_round = type == "cylinder" || type == "capsule";
  const bool has_segment = result.segment.has_value();
  const std::array<double, 3> s = numbers_of(geom, type == "sphere" || has_segment ? 1 : is_round ? 2 : 3, diagnostics);
  const double length = has_segment ? result.segment->length / 2.0 : is_round ? s[1] : s[2];
  result.half = {s[0], is_round || has_segment ? s[0] : s[1], length};
  if (type == "sphere") result.half = {s[0], s[0], s[0]};
  return result;
}

}  // namespace robcogen::import::from_mjcf
