// Torques as an SVG picture.
#pragma once

#include <string>
#include <vector>

#include "identification.h"

namespace identification {

// Draws for each joint the measured torques, those that the guess predicts, and those that the identified parameters
// predict. Returns the text of a complete SVG file without background, in colours that can be read on white and on
// black.
std::string picture(const std::vector<Instant>& instants, const Unknowns& guessed, const Unknowns& identified);

}  // namespace identification
