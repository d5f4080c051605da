// Simulation of the HyL leg: it drops from a height and hops on the spot.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace demo {

// The state at one instant. Positions are in the base frame, in its x-z plane (the plane of motion), in metres.
struct Instant {
  double time;  // s
  Eigen::Vector2d hip;
  Eigen::Vector2d knee;
  Eigen::Vector2d foot;
  double ground_force;  // N, vertical
};

// Simulates for `duration` (s) and returns one instant every 4 ms. The ground is the plane z = 0 of the base frame.
std::vector<Instant> hop(double duration);

// Weight of the whole robot, N.
double weight();

}  // namespace demo
