// The robot as a page: one HTML file that opens from disk and loads nothing.
#pragma once

#include <string>
#include <vector>

#include "support/diagnostics.h"
#include "view/robot.h"

namespace robcogen::view {

// What the page begins with.
struct PageOptions {
  std::vector<double> q, parameters;  // an element a coordinate, and a parameter
};

// `model`: the robot was `viewed` of it. The warnings are listed, each beside the link or joint that it is about.
std::string page(
    const driver::Model& model,
    const ViewedRobot& robot,
    const Diagnostics& diagnostics,
    const PageOptions& options);

}  // namespace robcogen::view
