// Torques as a picture in SVG.
#pragma once

#include <string>
#include <vector>

#include "identification.h"

namespace identification {

// Measured torques of each joint, those that the guess predicts, and those that the identified parameters predict. Text
// of a complete SVG file; no background, and colours that can be read on white and on black.
std::string picture(const std::vector<Instant>& instants, const Unknowns& guessed, const Unknowns& identified);

}  // namespace identification
