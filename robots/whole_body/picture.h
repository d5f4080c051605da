// Motions as SVG pictures: the robot, its centre of mass, the loads of its feet. They have no background, and colours
// that can be read on white and on black.
#pragma once

#include <string>

#include "motions.h"

namespace whole_body {

std::string picture(const Motion& motion);

}  // namespace whole_body
