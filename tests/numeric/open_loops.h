// Loops and couplings as constraints of a tree in which all joints are free, without any formula of the generator.
#pragma once

#include "model/kinematic_tree.h"
#include "robcogen/reference/loops.h"

namespace robcogen::numeric {

// Errors, in axes of the last link that carries both frames of a loop, and their rates: a column for each coordinate of
// a floating base, then one for each joint. For frames that must be parallel, these are the sines of the angles between
// them, and their relative angular velocity.
struct OpenLoops {
  reference::Vector<reference::Real> error;
  reference::Matrix<reference::Real> K;
};

// Returns the rows of all loops and of the declared couplings of `tree`. `tables` belongs to the same robot; `joints`
// are the positions of all joints.
OpenLoops open_loops(
    const model::KinematicTree& tree,
    const reflection::Robot& tables,
    const reference::Vector<reference::Real>& joints);

// Returns dK/dt v, by an eighth-order difference.
reference::Vector<reference::Real> change_of_rates(
    const model::KinematicTree& tree,
    const reflection::Robot& tables,
    const reference::Vector<reference::Real>& joints,
    const reference::Vector<reference::Real>& velocities);

// Adds the forces in a loop to the wrenches on the links of its ends (link axes, about link origins). The elements of
// loop_forces from `next` on are what the second frame exerts on the first one. Advances `next` past them.
void push(
    const model::KinematicTree& tree,
    const reflection::Robot& tables,
    const reference::Vector<reference::Real>& joints,
    int loop,
    const std::vector<double>& forces,
    std::size_t& next,
    std::vector<reference::Vector<reference::Real>>& wrenches);

// The joints that follow others without a loop, as indices of tables.couplings.
std::vector<int> declared_couplings(const model::KinematicTree& tree);

}  // namespace robcogen::numeric
