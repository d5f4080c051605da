// The generated code's times set against those of other libraries.
#pragma once

#include <string>
#include <vector>

#include "chart.h"
#include "results.h"

namespace robcogen::bench {

// How many times as long a call of the peer takes.
struct Ratio {
  std::string peer;
  Time time;
  double ratio = 0;
};

// One quantity of one robot.
struct Comparison {
  std::string quantity;
  std::string function;  // that is compared
  Time time;             // its own
  std::vector<Ratio> peers;
};

// Of the quantities that the generated library has, in the order of kQuantities; peers in their order.
std::vector<Comparison> comparisons(const Results& results);

// Over the robots for which the peer has the quantity.
struct Mean {
  std::string peer;
  std::string quantity;
  double ratio = 0;  // geometric mean
  int robots = 0;
};

// Of all robots; each robot's order is kept.
std::vector<std::string> all_peers(const std::vector<Results>& robots);

// For each existing peer and quantity; peers in the order of all_peers, then in that of kQuantities.
std::vector<Mean> geometric_means(const std::vector<Results>& robots);

// Inverse dynamics, forward dynamics and inertia matrix of the generated code and of all peers.
std::vector<ChartPanel> chart_panels(const std::vector<Results>& robots);

// "inverse dynamics", of an element of kQuantities.
std::string title(const std::string& quantity);

int degrees_of_freedom(const Results& results);

}  // namespace robcogen::bench
