// The combinations of inertial parameters that a robot's motions can tell apart.
//
// Forces depend on the parameters of a link, and of all beyond it, only in the combinations that a joint below feels:
// the power of a possible motion against the change of another. RelativeMotion from a link, these are linear functions
// of ten numbers; those that must not change when the joint moves follow by differentiation, and so on from the base to
// the leaves: no sample of states, and no rank of a large matrix, is needed. The count is minimal where joints are not
// coupled. (The idea of Wensing, Niemeyer and Slotine 2017; rules for the same: Khalil and Bennis 1995.)
#pragma once

#include <array>
#include <vector>

#include "algorithm/dynamics/loads.h"
#include "algorithm/identification/inertial_parameters.h"

namespace robcogen::algorithm {

// A combination of a link's inertial parameters, with moments of mass: one with coefficient 1 that is in no other
// combination of the link, and others.
struct Combination {
  int parameter = 0;
  std::array<double, kParametersOfLink> coefficients{};
};

// By link, the combinations that are felt of its parameters and of those that the links beyond leave to it; empty for a
// fixed base. Standard gravity is along the z axis of a fixed base; as an input it has any direction. If the answer
// depends on the values of parameters of the document, it has all that may be felt.
std::vector<std::vector<Combination>> identifiable_combinations(const model::KinematicTree& tree, Loads loads);

}  // namespace robcogen::algorithm
