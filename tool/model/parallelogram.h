// Planar loops whose links form a parallelogram: opposite links stay parallel, so joints follow one another linearly.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// The linear relations between the joints of a parallelogram.
class Parallelogram {
 public:
  // By joint: its coefficients in two sums of joint positions, both of which are zero in every position.
  using Sums = std::map<int, std::array<int, 2>>;

  Parallelogram(Sums sums, bool is_flat) : sums_(std::move(sums)), is_flat_(is_flat) {}

  // Whether the positions of these two joints follow from those of the others.
  bool determines(const std::vector<int>& joints) const;
  // By dependent joint: the joints that it follows.
  std::vector<std::vector<LoopShare>> shares(const std::vector<int>& dependents) const;
  // Whether the links are parallel rather than crossed in this position, in which the loop is closed.
  bool holds(const std::vector<double>& q) const;
  // Whether all pivots are on one line: a position that crossed links share.
  bool is_flat() const { return is_flat_; }

 private:
  Sums sums_;
  bool is_flat_;
};

// Returns the parallelogram that a planar closure forms when all joints are at zero, or nullopt if its links do not
// form one, or do so only for some values of the parameters.
std::optional<Parallelogram> find_parallelogram(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& parameters,
    const Closure& closure);

// Replaces closures that have shares by linear couplings, and moves them to the parallelograms of the tree; the other
// closures stay, in their order. If a joint that a parallelogram follows depends nonlinearly on the coordinates, so do
// the parallelogram's dependent joints, and its closure stays unchanged.
void couple_parallelograms(KinematicTree& tree);

}  // namespace robcogen::model
