// Random drives on the joints of random robots.
#pragma once

#include <cstdint>

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

// Adds a random drive to most joints of the robot, with rotors on any links, and tendons to some robots. The result
// depends only on the seed.
model::KinematicTree with_random_drives(model::KinematicTree robot, std::uint64_t seed);

// A robot whose only drives are rotors, and the same robot with a body and a joint in place of each rotor.
struct RotorBodies {
  model::KinematicTree with_rotors;
  model::KinematicTree with_bodies;  // the joints of the rotors come last
  std::vector<int> driven;           // by rotor: the joint that turns it
  std::vector<double> ratios;
};
RotorBodies with_rotor_bodies(const model::KinematicTree& robot, std::uint64_t seed);

}  // namespace robcogen::numeric
