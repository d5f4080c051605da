// Tracking as an SVG picture.
#pragma once

#include <string>
#include <vector>

#include "tracking.h"

namespace tracking {

// Draws the desired and the actual motion of hip and knee with both control laws, and below them the errors of all
// runs. Returns the text of a complete SVG file without background, in colours that can be read on white and on black.
std::string picture(const std::vector<Result>& runs);

// The name of a run, such as `inverse dynamics, 250 Hz`.
std::string name_of(const Result& run);

}  // namespace tracking
