// Random kinematic trees for property tests, and how to make a failing one small.
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

// The same robot for the same seed, everywhere. Most robots are small; every inertia matrix is well positive definite,
// all mass properties are those of real bodies. About a third of the offsets are zero, a third of the rotations
// multiples of a right angle, since that is where code generators cut corners.
model::KinematicTree random_robot(std::uint64_t seed, const RobotOptions& options = {});

// A few pairs of frames: towards the base, away from it, across branches, within a link.
model::DesiredTransforms random_desired(std::uint64_t seed, const model::KinematicTree& robot);

// The robot without one of its leaf links, its joint and the frames on both. `leaf` is a link without child joints.
model::KinematicTree without_leaf(const model::KinematicTree& robot, int leaf);

// A smaller robot that still fails: leaf links and user frames are removed as long as `fails` holds.
model::KinematicTree shrink(model::KinematicTree robot, const std::function<bool(const model::KinematicTree&)>& fails);

// For messages: one line a link with its joint, placement and mass.
std::string describe(const model::KinematicTree& robot);

}  // namespace robcogen::numeric
