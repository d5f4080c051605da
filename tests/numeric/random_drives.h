// Random drives on the joints of random robots.
#pragma once

#include <cstdint>

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

// The robot with a random drive on most of its joints, and rotors on any links; the same for the same seed.
model::KinematicTree with_random_drives(model::KinematicTree robot, std::uint64_t seed);

// A robot whose drives are rotors alone, and the same with a body and a joint for each rotor.
struct RotorBodies {
  model::KinematicTree with_rotors;
  model::KinematicTree with_bodies;  // the joints of the rotors come last
  std::vector<int> driven;           // by rotor: the joint that turns it
  std::vector<double> ratios;
};
RotorBodies with_rotor_bodies(const model::KinematicTree& robot, std::uint64_t seed);

}  // namespace robcogen::numeric
