// Motions as SVG pictures: figures of the robot, forces of its joints, and the cost over the iterations. They have no
// background, and colours that can be read on white and on black.
#pragma once

#include <string>

#include "swing_up.h"

namespace optimal_control {

std::string picture(const CartPoleMotion& motion);
std::string picture(const PumaMotion& motion);

}  // namespace optimal_control
