// The robot as a drawing: SVG that is readable on white and on dark paper.
#pragma once

#include <string>
#include <vector>

#include "driver/load.h"
#include "view/robot.h"

namespace robcogen::view {

// Which elements of the joint-space inertia matrix are not zero in every position; rows of 0 and 1.
struct Pattern {
  std::vector<std::string> names;  // of rows: base wx … base vz where the base floats, then joints
  std::vector<std::vector<bool>> rows;
};

// Of the robot as the document has it. A Failure when it has no mass properties.
Pattern inertia_pattern(const driver::Model& model);

struct DrawingOptions {
  double azimuth = -60, elevation = 20;  // of the viewer seen from the robot, degrees
  const Pattern* pattern = nullptr;      // drawn beside the robot, where there is one
};

// Links as bars between the origins of their joints, joint axes, frames of the user with names, centres of mass. The
// text follows from the arguments alone.
std::string draw(const ViewedRobot& robot, const Posture& posture, const DrawingOptions& options);

}  // namespace robcogen::view
