// Pivots of a factorisation of the joint-space inertia matrix H, computed numerically.
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

// Reproducible pseudo-random numbers between 0.5 and 1.5, so that no angle, length or mass has a special value.
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
  std::vector<double> joints;  // by joint, or by coordinate for robots with couplings
  std::vector<double> base;    // of a floating base; empty for a fixed base
};

enum class Beyond { free, locked };  // the joints beyond the joint under examination

// Returns the pivots at a position without special angles, with parameters without special values. Every articulated
// inertia is increased by the fraction `addition` of itself.
Pivots pivots_of(const KinematicTree& tree, Beyond beyond, double addition);
// The same for a robot with coupled joints, whose inertia matrix does not have the structure of a tree.
Pivots pivots_of_coordinates(const KinematicTree& tree, Beyond beyond, double addition);

}  // namespace robcogen::model
