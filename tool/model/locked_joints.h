// Finds which joints do not move when some are locked, and where they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/changes.h"

namespace robcogen::model {

// The motion of a locked joint from its frame to its child, and, unless it is spherical, its position (rad, m).
struct LockedJoint {
  Placement motion;
  Quantity position;
};

struct LockedJoints {
  std::vector<std::optional<LockedJoint>> joints;  // by joint of the description; empty for those that move
  std::vector<std::string> loops;                  // that cannot move
  // Loops with locked joints that can still move, and, by joint of the description, where these are assembled.
  std::vector<std::string> reassembled;
  std::vector<std::optional<double>> assembled;
  // The independent joints of loops that now have fewer: they are to be chosen again.
  std::vector<std::string> rechosen;
};

// Replaces parameters that locks name by constants. Reports locks that name neither a joint nor a parameter.
void lock_parameters(Description& description, const Changes& changes, Diagnostics& diagnostics);

// `tree` is the robot of the description before joints are locked. nullopt if an error was reported.
std::optional<LockedJoints> locked_joints(
    const Description& description,
    const KinematicTree& tree,
    const Changes& changes,
    Diagnostics& diagnostics);

}  // namespace robcogen::model
