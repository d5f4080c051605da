// Random robots with loops, as documents.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

// A short random tree that carries one or two mechanisms, in planes of any direction, with frames, drives and a
// coupling: four-bars of all choices of the joint that leads, sliders that follow and that lead, cylinders, five-bars,
// rods of a fixed length. All of them close within 0.3 rad and 0.03 m of q = 0.
std::string looped_document(std::uint64_t seed);

// Its robot; nullopt for the few random loops that do not close. Other errors are failures of the test.
std::optional<model::KinematicTree> looped_tree(std::uint64_t seed);

// Of parameters, a little off their defaults.
std::vector<double> values_near_defaults(const model::KinematicTree& tree);

}  // namespace robcogen::numeric
