// Robots whose loops no formula closes: spatial loops, loops with frames that slide or are welded, and loops that must
// be closed together.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace robcogen::numeric {

using Names = std::vector<std::string>;

struct IterativeRobot {
  std::string name, document;
  Names coordinates, followers;
};

void PrintTo(const IterativeRobot& robot, std::ostream* out);

const std::vector<IterativeRobot>& iterative_robots();
// The document of the first of them, with the coordinates `leaders` and the second frame rotated by `turned`.
std::string cut_rod(const std::string& leaders, const std::string& turned = "0.0, -PI/2.0, PI");

}  // namespace robcogen::numeric
