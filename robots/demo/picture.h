// The motion of the leg as a picture in SVG.
#pragma once

#include <string>
#include <vector>

#include "hop.h"

namespace demo {

// Stick figures of the leg over time with the paths of hip and foot, and below them the force of the ground. Text of a
// complete SVG file; no background, and colours that can be read on white and on black.
std::string picture(const std::vector<Instant>& instants);

}  // namespace demo
