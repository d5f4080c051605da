// Limbs that look as if they corresponded to each other, but are not congruent (limbs.h).
#pragma once

#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Two limbs on one link, each named by its first joint, and the first difference between them.
struct UnlikeLimbs {
  std::string first, second;
  std::string reason;  // `arm_l_7 is revolute, arm_r_7 is prismatic`
};

// The limbs of at least three joints that have no congruent limb, in pairs on one link with nearly equal numbers of
// joints. Limbs within congruent limbs are not searched.
std::vector<UnlikeLimbs> unlike_limbs(const KinematicTree& tree);

}  // namespace robcogen::model
