// The types and sizes of geoms.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "import/mjcf/segment.h"

namespace robcogen::import::from_mjcf {

struct GeomSize {
  // m: half axes, or half edges. Of a cylinder and a capsule, the radius twice, and half the length without half
  // spheres.
  std::array<double, 3> half = {1.0, 1.0, 1.0};
  std::optional<Segment> segment = {};  // from `fromto`
};

// `sphere` by default. Reports an unknown type.
std::string type_of_geom(const Element& geom, Diagnostics& diagnostics);

// Of a sphere, capsule, ellipsoid, cylinder or box. Reports sizes that are missing or not positive.
GeomSize read_size(const Element& geom, const std::string& type, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
