// Random robots with loops, as documents.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

// The document of a short random tree that carries one or two mechanisms, in planes of any direction, with frames,
// drives and a coupling. Mechanisms are four-bars with each choice of the leading joint, sliders that follow or lead,
// cylinders, five-bars, and rods of fixed length. All of them close within 0.3 rad and 0.03 m of q = 0.
std::string looped_document(std::uint64_t seed);

// The robot of that document, or nullopt for the few random loops that do not close. Other errors fail the test.
std::optional<model::KinematicTree> looped_tree(std::uint64_t seed);

// Values of the parameters, slightly off their defaults.
std::vector<double> values_near_defaults(const model::KinematicTree& tree);

}  // namespace robcogen::numeric
