// Link frames that correspond in congruent limbs.
//
// The search gives each limb the frames that cost least for that limb. If limbs differ by rounding, as the fingers of a
// gripper do whose second finger is the first one turned by 3.14159, the frames of two limbs need not correspond. Then
// the programs of the limbs have different statements, and the limbs cannot be computed in the lanes of vectors.
#pragma once

#include "algorithm/formulation/formulation.h"

namespace robcogen::algorithm {

// The frames of the formulation, except in limbs that can be computed in lanes: these get the frames that the rules of
// the first limb's frames (frame_candidates.h) give them. Limbs for which a rule has no candidate keep their frames.
LinkFrames corresponding_frames(const model::KinematicTree& tree, const Formulation& formulation);

}  // namespace robcogen::algorithm
