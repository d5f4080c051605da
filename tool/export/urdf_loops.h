// Loops and couplings of URDF+, which plain URDF does not have (Chignoli, Slotine, Wensing and Kim, arXiv 2411.19753).
#pragma once

#include <optional>

#include "model/kinematic_tree.h"

namespace robcogen::exporting {

// A coupling of two links: the sum of the positions of the joints from the last link that carries both to the successor
// is the sum for the joints to the predecessor, times the ratio.
struct LinkCoupling {
  int predecessor = -1, successor = -1;
  double ratio = 0.0;
};

// The coupling of a joint in this form; nullopt if it does not have this form.
std::optional<LinkCoupling> link_coupling(const model::KinematicTree& tree, const model::Coupling& coupling);

// Whether URDF+ can express this loop: a hinge that is assembled on the drawn branch.
bool may_be_urdf_loop(const model::LoopJoint& loop);

// Whether the joint follows others through a loop.
bool follows_through_loop(const model::KinematicTree& tree, int joint);

// Whether reading the loop creates this frame.
bool is_made_by_loop(const model::KinematicTree& tree, const std::string& frame);

}  // namespace robcogen::exporting
