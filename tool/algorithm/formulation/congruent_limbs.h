// The congruent limbs of a robot, and the inputs of its programs that belong to them.
#pragma once

#include <string>
#include <vector>

#include "model/limbs.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// Limbs of one class that can share the lanes of vectors: 2, 4 or 8 of them. Six legs are four and two.
struct LimbsInLanes {
  std::vector<std::string> names;        // the first joint of each limb
  std::vector<std::vector<int>> joints;  // tuples of corresponding joints, one of each limb
};

std::vector<LimbsInLanes> limbs_in_lanes(const model::KinematicTree& tree);

// The elements of the program's inputs that correspond, one of each limb, as flat indices: elements of the joints of
// the limbs and of the links that these move.
std::vector<std::vector<int>> limb_inputs(
    const model::KinematicTree& tree,
    const LimbsInLanes& limbs,
    const symbolic::Program& program);

}  // namespace robcogen::algorithm
