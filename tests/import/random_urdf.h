// Random robots as URDF text: arbitrary axes, angles and inertias, fixed joints, massless links, names that are not
// identifiers.
#pragma once

#include <cstdint>
#include <string>

namespace robcogen::test {

// The same seed gives the same text. `exact_angles`: all angles are multiples of PI/12, spelled as the nearest doubles;
// `angle_error` is added to them with either sign.
struct UrdfOptions {
  bool exact_angles = false;
  double angle_error = 0.0;
};

std::string random_urdf(std::uint64_t seed, const UrdfOptions& options = {});

}  // namespace robcogen::test
