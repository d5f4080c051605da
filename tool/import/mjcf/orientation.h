// Reads poses of elements: `pos`, and the five ways to give an orientation.
#pragma once

#include "import/mjcf/settings.h"
#include "import/pose.h"

namespace robcogen::import::from_mjcf {

// Reports more than one orientation, and orientations without a direction. Angles within rounding of a multiple of PI/4
// are exact.
Rotation orientation_of(const Element& element, const Settings& settings, Diagnostics& diagnostics);
// Returns the smallest rotation that turns z to this direction, which must not be zero; a rotation about x if the
// direction is opposite to z.
Rotation smallest_rotation_to_axis(const std::array<Number, 3>& direction);
// Returns the orientation by Euler angles, each multiplied by `factor`.
Rotation multiple_of_euler(
    const Attribute& euler,
    std::size_t factor,
    const Settings& settings,
    Diagnostics& diagnostics);
Pose pose_of(const Element& element, const Settings& settings, Diagnostics& diagnostics);
model::Quantity quantity(const Number& number);
std::array<model::Quantity, 3> quantities(const std::array<Number, 3>& numbers);

}  // namespace robcogen::import::from_mjcf
