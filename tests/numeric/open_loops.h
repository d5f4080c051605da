// Loops and couplings as constraints of a tree in which all joints are free, by no formula of the generator.
#pragma once

#include "model/kinematic_tree.h"
#include "robcogen/reference/loops.h"

namespace robcogen::numeric {

// Errors, in axes of the last link that carries both frames of a loop, and their rates, by coordinate of a floating
// base, then by joint. Of frames that are to be parallel the sines of the angles between them, and their relative
// angular velocity.
struct OpenLoops {
  reference::Vector<reference::Real> error;
  reference::Matrix<reference::Real> K;
};

// `couplings`: of `tree`, that are made by no loop. Tables of the same robot; its joints at these positions.
OpenLoops open_loops(
    const model::KinematicTree& tree,
    const reflection::Robot& tables,
    const reference::Vector<reference::Real>& joints);

// dK/dt v, by a difference of eighth order.
reference::Vector<reference::Real> change_of_rates(
    const model::KinematicTree& tree,
    const reflection::Robot& tables,
    const reference::Vector<reference::Real>& joints,
    const reference::Vector<reference::Real>& velocities);

// Wrenches on the links of a loop's ends (link axes, about link origins), of what the second frame pushes the first one
// with: elements of loop_forces from `next` on. Moves `next` behind them.
void push(
    const model::KinematicTree& tree,
    const reflection::Robot& tables,
    const reference::Vector<reference::Real>& joints,
    int loop,
    const std::vector<double>& forces,
    std::size_t& next,
    std::vector<reference::Vector<reference::Real>>& wrenches);

// The joints that follow others through no loop, as places in tables.couplings.
std::vector<int> declared_couplings(const model::KinematicTree& tree);

}  // namespace robcogen::numeric
