// Corresponding frames for congruent limbs.
//
// The search gives each limb the frames that cost least for it. Where limbs differ by roundings, as in a mirrored
// gripper that was turned by 3.14159, these need not correspond, and then limbs that could share the lanes of vectors
// compute by programs of different shape.
#pragma once

#include "algorithm/formulation/formulation.h"

namespace robcogen::algorithm {

// The frames of the formulation, in which the limbs of a class that can share lanes follow its first limb, by the same
// rules (frame_candidates.h). Limbs without such frames keep theirs, and so do those whose frames correspond.
LinkFrames corresponding_frames(const model::KinematicTree& tree, const Formulation& formulation);

}  // namespace robcogen::algorithm
