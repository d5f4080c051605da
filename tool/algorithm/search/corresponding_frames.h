// Finds corresponding frames for congruent limbs.
//
// The search gives each limb the frames that cost least for it. If limbs differ by rounding, like those of a mirrored
// gripper that was turned by 3.14159, these frames need not correspond, and limbs that could share the lanes of vectors
// get programs of different shape.
#pragma once

#include "algorithm/formulation/formulation.h"

namespace robcogen::algorithm {

// The frames of the formulation, except that limbs that can share lanes follow the first limb of their class, by the
// same rules (frame_candidates.h). Limbs without such frames keep theirs, and so do those whose frames correspond.
LinkFrames corresponding_frames(const model::KinematicTree& tree, const Formulation& formulation);

}  // namespace robcogen::algorithm
