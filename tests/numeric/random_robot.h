// Random kinematic trees for property tests, and a function that shrinks those that fail.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

enum class Shape { any, chain, star };

struct RobotOptions {
  int min_joints = 1;
  int max_joints = 40;
  Shape shape = Shape::any;   // any: chains, stars, and trees in between
  bool odd_documents = true;  // massless links in between, masses in user frames, shuffled declarations
  bool screws = true;         // helical joints
};

// The robot depends only on the seed, on every platform. Most robots are small; every inertia matrix is well positive
// definite, and all mass properties are physical. About a third of the offsets are zero, and a third of the rotations
// are multiples of a right angle, because these are the cases that code generators simplify.
model::KinematicTree random_robot(std::uint64_t seed, const RobotOptions& options = {});

// A few pairs of frames: towards the base, away from it, across branches, within a link.
model::DesiredTransforms random_desired(std::uint64_t seed, const model::KinematicTree& robot);

// Removes one leaf link with its joint and the frames on both. `leaf` is a link without child joints.
model::KinematicTree without_leaf(const model::KinematicTree& robot, int leaf);

// Returns a smaller robot that still fails: removes leaf links and user frames as long as `fails` holds.
model::KinematicTree shrink(model::KinematicTree robot, const std::function<bool(const model::KinematicTree&)>& fails);

// A description for messages: one line per link with its joint, placement and mass.
std::string describe(const model::KinematicTree& robot);

}  // namespace robcogen::numeric
