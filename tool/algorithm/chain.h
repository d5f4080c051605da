// The way from one frame of a robot to another, past the joints between them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "algorithm/reached.h"

namespace robcogen::algorithm {

// A joint on the way, passed from parent to child, or back: then its motion counts the other way.
struct Motor {
  int joint = -1;
  bool backward = false;
  bool revolute = true;
};

// A part of the way that ends with a joint's own motion, so that constant turns merge with the joint's and each joint
// costs one sine and cosine. The last stretch ends without one.
struct Stretch {
  std::vector<model::PrimitiveTransform> primitives;
  std::optional<Motor> motor;
};

// left_X_right, cut behind each joint.
std::vector<Stretch> chain(const model::KinematicTree& tree, const model::FramePair& frames);

// Starts the section of a stretch, and makes its pose: of its last frame in its first.
Pose pose_of(Trace& trace, const Stretch& stretch, const std::vector<Expression>& q);

// Walks the whole chain and returns its end. Calls at_joint behind each joint; where it stands, turning about the z
// axis or sliding along it has left the joint's axis where it was.
Reached walk(
    Trace& trace,
    const std::vector<Stretch>& chain,
    const std::vector<Expression>& q,
    const std::function<void(const Motor&, const Reached&)>& at_joint,
    int moment_from = Reached::kNoStretch);

}  // namespace robcogen::algorithm
