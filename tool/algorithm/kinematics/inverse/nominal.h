// The nominal chain of one whose axes are slightly off: of a calibrated arm, or one with rounded numbers.
#pragma once

#include "algorithm/kinematics/inverse/serial_chain.h"

namespace robcogen::algorithm::inversion {

struct NominalChain {
  SerialChain chain;
  // By how much its axes differ at most (rad, m).
  double angle = 0.0, distance = 0.0;

  bool differs() const { return angle >= kSameDirection || distance > chain.same_point; }
};

// Each axis in turn is made parallel to the axis before it or perpendicular to it, and to meet it, or the point in
// which axes before it meet, where it is off by less than the tolerance (rad, and m per metre of reach); and so that
// the two axes next to one are nearest to it in the same point.
NominalChain nominal_chain(const SerialChain& chain, double tolerance);

}  // namespace robcogen::algorithm::inversion
