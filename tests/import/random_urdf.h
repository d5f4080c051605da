// Random robots as URDF text: any axes, angles and inertias, fixed joints, links without mass, names that are no
// identifiers.
#pragma once

#include <cstdint>
#include <string>

namespace robcogen::test {

// The same text for the same seed. `exact_angles`: all angles are multiples of PI/12, spelled as the nearest doubles;
// `angle_error` is added to them, with either sign.
struct UrdfOptions {
  bool exact_angles = false;
  double angle_error = 0.0;
};

std::string random_urdf(std::uint64_t seed, const UrdfOptions& options = {});

}  // namespace robcogen::test
