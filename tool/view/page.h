// The robot as a page: one HTML file that opens from disk and loads nothing.
#pragma once

#include <string>
#include <vector>

#include "support/diagnostics.h"
#include "view/robot.h"

namespace robcogen::view {

// The initial state of the page.
struct PageOptions {
  std::vector<double> q, parameters;  // one element per coordinate, and one per parameter
};

// `robot` must be `viewed(model)`. The page lists the warnings, each with the link or joint that it is about.
std::string page(
    const driver::Model& model,
    const ViewedRobot& robot,
    const Diagnostics& diagnostics,
    const PageOptions& options);

}  // namespace robcogen::view
