// A drawing of the time of a call against degrees of freedom.
#pragma once

#include <string>
#include <vector>

namespace robcogen::bench {

struct ChartPoint {
  std::string robot;
  int degrees_of_freedom = 0;  // with a floating base: 6 more than joints
  bool floating_base = false;
  double nanoseconds = 0;  // positive
};

// One library.
struct ChartSeries {
  std::string name;
  std::vector<ChartPoint> points;
};

// One quantity.
struct ChartPanel {
  std::string title;
  std::vector<ChartSeries> series;
};

// An SVG of the panels, one below the other, with common axes: degrees of freedom, and time on a logarithmic scale. A
// series has the same colour and marker in all panels, hollow for floating bases; a point's title names it. The
// background is transparent, and all colours are visible on white and on black.
std::string svg(const std::vector<ChartPanel>& panels);

// The position of a value on a logarithmic scale: 0 at `low`, 1 at `high`. All are positive.
double log_position(double value, double low, double high);

// Moves ascending places apart, to the right only, so that neighbours are at least `distance` from each other.
std::vector<double> spread(std::vector<double> places, double distance);

}  // namespace robcogen::bench
