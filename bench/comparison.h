// The generated code's times compared with those of other libraries.
#pragma once

#include <string>
#include <vector>

#include "chart.h"
#include "results.h"

namespace robcogen::bench {

// The time of a peer's call, and its ratio to that of the generated code.
struct Ratio {
  std::string peer;
  Time time;
  double ratio = 0;
};

// One quantity of one robot.
struct Comparison {
  std::string quantity;
  std::string function;  // generated function that is compared
  Time time;             // of this function
  std::vector<Ratio> peers;
};

// One comparison for each quantity that the generated library has, in the order of kQuantities; peers in the order of
// the results.
std::vector<Comparison> comparisons(const Results& results);

// A mean over the robots for which the peer has the quantity.
struct Mean {
  std::string peer;
  std::string quantity;
  double ratio = 0;  // geometric mean
  int robots = 0;
};

// The peers of all robots; the order of each robot is kept.
std::vector<std::string> all_peers(const std::vector<Results>& robots);

// One mean for each existing peer and quantity, in the order of all_peers, then of kQuantities.
std::vector<Mean> geometric_means(const std::vector<Results>& robots);

// Inverse dynamics, forward dynamics and inertia matrix of the generated code and of all peers.
std::vector<ChartPanel> chart_panels(const std::vector<Results>& robots);

// The title of an element of kQuantities, such as "inverse dynamics".
std::string title(const std::string& quantity);

int degrees_of_freedom(const Results& results);

}  // namespace robcogen::bench
