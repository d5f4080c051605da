// Tracking as a picture in SVG.
#pragma once

#include <string>
#include <vector>

#include "tracking.h"

namespace tracking {

// What hip and knee should do and do, under both laws, and the errors of all runs below. Text of a complete SVG file;
// no background, and colours that can be read on white and on black.
std::string picture(const std::vector<Result>& runs);

// As in `inverse dynamics, 250 Hz`.
std::string name_of(const Result& run);

}  // namespace tracking
