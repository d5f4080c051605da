// The plane in which a loop moves.
#pragma once

#include <string>

#include "model/loop_geometry.h"

namespace robcogen::model {

// A loop is closed where its ends miss one another by this part of its size, or less.
inline constexpr double kClosed = 1e-9;

// What is wrong with a loop that should move in a plane: a message without its place; all empty where nothing is.
struct PlaneFault {
  std::string code, message, hint;
  bool is_in_space = false;  // not a mistake: the loop is not meant to move in a plane
};

// Sets the plane and the senses of a closure of a point or a hinge. `parameters` are values of the tree's.
PlaneFault find_plane(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& parameters,
    Closure& closure);

// The message that a loop does not close, `where`; `along`: in which direction, or all.
PlaneFault open_loop(
    const LoopJoint& loop,
    double gap,
    const std::string& where = "at q = 0",
    const std::string& along = "");

// A length: of the longest lever of a joint.
double size_of(const LoopPosture& posture);

}  // namespace robcogen::model
