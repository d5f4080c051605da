// Pivots of a factorisation of the joint-space inertia matrix H, in numbers.
//
// Eliminating the joints from the leaves to the base (the articulated-body recursion, Featherstone 2008, section 7.3)
// yields them: pivot j is the inertia that joint j meets while the joints beyond it are free.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Repeatable numbers between 0.5 and 1.5: no special angles, lengths or masses.
class OrdinaryNumbers {
 public:
  double next() { return 0.5 + static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::vector<double> next(std::size_t count) {
    std::vector<double> values(count);
    for (double& value : values) value = next();
    return values;
  }

 private:
  std::mt19937_64 engine_{5489};
};

struct Pivots {
  std::vector<double> joints;  // of coupled robots: coordinates
  std::vector<double> base;    // of a floating base; empty for a fixed one
};

enum class Beyond { free, locked };  // the joints beyond the one under examination

// At a position without special angles, with parameters without special values. Every articulated inertia is increased
// by this share of itself.
Pivots pivots_of(const KinematicTree& tree, Beyond beyond, double addition);
// Of a robot with coupled joints, whose matrix is not that of a tree.
Pivots pivots_of_coordinates(const KinematicTree& tree, Beyond beyond, double addition);

}  // namespace robcogen::model
