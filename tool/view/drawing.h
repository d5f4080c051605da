// The robot as a drawing: an SVG that is readable on white and on dark paper.
#pragma once

#include <string>
#include <vector>

#include "driver/load.h"
#include "view/robot.h"

namespace robcogen::view {

// The elements of the joint-space inertia matrix that are not zero in every position.
struct Pattern {
  std::vector<std::string> names;  // of rows: base wx … base vz if the base floats, then joints
  std::vector<std::vector<bool>> rows;
};

// The pattern of the robot as the document has it. Throws a Failure if the robot has no mass properties.
Pattern inertia_pattern(const driver::Model& model);

struct DrawingOptions {
  double azimuth = -60, elevation = 20;  // of the viewer as seen from the robot, degrees
  const Pattern* pattern = nullptr;      // drawn next to the robot; null: none
  bool is_plain = false;                 // a small picture of links, joint axes and the base, without a word
};

// Draws links as bars between the origins of their joints, joint axes, user frames with names, and centres of mass. The
// text depends on the arguments alone. A plain drawing has no pattern.
std::string draw(const ViewedRobot& robot, const Posture& posture, const DrawingOptions& options);

}  // namespace robcogen::view
