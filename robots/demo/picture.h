// The motion of the leg as a picture in SVG.
#pragma once

#include <string>
#include <vector>

#include "hop.h"

namespace demo {

// Draws stick figures of the leg over time with the paths of hip and foot, and below them the force of the ground.
// Returns the text of a complete SVG file without background, in colours that can be read on white and on black.
std::string picture(const std::vector<Instant>& instants);

}  // namespace demo
