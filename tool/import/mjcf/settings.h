// What the elements `compiler` and `option` say of the whole model.
#pragma once

#include <string>

#include "import/mjcf/element.h"

namespace robcogen::import::from_mjcf {

enum class InertiaFromGeoms { never, always, where_absent };

struct Settings {
  bool degrees = true;
  std::string euler_sequence = "xyz";  // axes of the turns; capitals are fixed axes
  InertiaFromGeoms inertia_from_geoms = InertiaFromGeoms::where_absent;
  bool limits_follow_ranges = true;  // a joint with a range is limited when it does not say otherwise
  bool balances_inertias = false;
  Number least_mass, least_moment;  // MuJoCo raises smaller ones
  Place group_range;                // of geoms that have mass; without a source: all do

  // In radians.
  Number angle(const Number& written) const { return degrees ? written * Number::pi_multiple(1, 180) : written; }
};

// Later elements change what earlier ones say. Reports what is malformed, what changes the model in a manner that is
// not supported (global coordinates, a total mass), and with notes or warnings: other gravity than (0, 0, -9.81),
// forces of a medium, and flags that disable forces.
Settings read_settings(const Element& root, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
