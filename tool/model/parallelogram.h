// Loops in a plane whose links form a parallelogram: opposite links turn alike, so that joints follow others by sums.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// What the joints of a parallelogram have in common.
class Parallelogram {
 public:
  // By joint, how much it counts in each of two sums, which are zero in every position.
  using Sums = std::map<int, std::array<int, 2>>;

  Parallelogram(Sums sums, bool is_flat) : sums_(std::move(sums)), is_flat_(is_flat) {}

  // Whether these two joints follow all others.
  bool determines(const std::vector<int>& joints) const;
  // By dependent joint: those that it follows.
  std::vector<std::vector<LoopShare>> shares(const std::vector<int>& dependents) const;
  // Whether its links are parallel, and not crossed, in this position in which it is closed.
  bool holds(const std::vector<double>& q) const;
  // Whether all of its pivots are on one line, where crossed links meet, too.
  bool is_flat() const { return is_flat_; }

 private:
  Sums sums_;
  bool is_flat_;
};

// Of a closure in a plane that is closed where all joints are at zero; nullopt where the links are no parallelogram
// there, or are one for some values of parameters only.
std::optional<Parallelogram> find_parallelogram(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& parameters,
    const Closure& closure);

// Makes closures that have shares linear couplings, and parallelograms of the tree, and leaves the others, in their
// order. Where a joint that leads a parallelogram follows through a loop in no proportion, so do those that follow it:
// its closure stays as it is.
void couple_parallelograms(KinematicTree& tree);

}  // namespace robcogen::model
