// Compares two descriptions of one robot by their results.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::test {

// Largest differences between two robots at random states, relative to the compared values. Joints are matched by name.
// Forces and accelerations are weighted by the inertia that each joint moves, so that a finger counts as much as a hip.
struct Differences {
  double inertia_matrix = 0;    // of H(i, j), relative to sqrt(H(i, i) H(j, j))
  double inverse_dynamics = 0;  // with the base's wrench, if it floats
  double forward_dynamics = 0;  // with the base's acceleration, if it floats; where the inertia matrix is regular
  double poses = 0;             // of links in the base, by name: see `named_frame`
};

// Both robots must have the same joints by name and both have a fixed or both a floating base; throws otherwise.
Differences differences(
    const model::KinematicTree& found,
    const model::KinematicTree& expected,
    std::uint64_t seed,
    int states);

// The names that the links and frames of this robot have in a URDF: those of its links and of its user frames that are
// not hidden.
std::vector<std::string> named_frames(const model::KinematicTree& tree);

// The frame with this name: the user frame, or else the link frame.
model::Frame named_frame(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::test
