// The plane in which a planar loop moves.
#pragma once

#include <string>

#include "model/loop_geometry.h"

namespace robcogen::model {

// A loop is closed if the gap between its ends is at most this fraction of its size.
inline constexpr double kClosed = 1e-9;

// What is wrong with a loop that should move in a plane: a message without a place. All fields are empty if nothing is
// wrong.
struct PlaneFault {
  std::string code, message, hint;
  bool is_in_space = false;  // not a mistake: the loop is not meant to move in a plane
};

// Sets the plane and the senses of the closure of a point or hinge loop. `parameters` are the values of the tree's
// parameters.
PlaneFault find_plane(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& parameters,
    Closure& closure);

// Returns by how much (m) a loop is open that is not closed by `error` (m): a loop that keeps a distance misses it, and
// its error is half the difference of the squares divided by it.
double gap_of(const LoopJoint& loop, const LoopPosture& posture, double length, double error);

// Returns the message that a loop does not close. `where` tells in which position; `along` in which direction, or is
// empty.
PlaneFault open_loop(
    const LoopJoint& loop,
    double gap,
    const std::string& where = "at q = 0",
    const std::string& along = "");

// Returns the size of a loop (m): the longest lever arm of a joint, or the gap if that is longer.
double size_of(const LoopPosture& posture);

}  // namespace robcogen::model
