// The steps of a plan: how one joint is found from joints that are known.
//
// An invariant of two features (distance, angle, height) is equal both ways around the loop of chain and target, so the
// joints of the features drop out. Where one unknown joint remains, the equation has two roots. Where one feature
// leaves one unknown joint, the joint turns a known vector into a known vector.
#pragma once

#include <string>
#include <vector>

#include "algorithm/kinematics/inverse/features.h"

namespace robcogen::algorithm::inversion {

struct Step {
  enum class Equation {
    vector,             // b alone: one root
    angle,              // of directions
    distance,           // of points
    distance_in_plane,  // the same, where the heights over the plane agree
    height              // of a point over a plane
  };
  Equation equation = Equation::vector;
  int joint = 0;      // of the chain
  Feature a, b;       // a comes first in the chain
  Numbers3 normal{};  // of the plane in which a distance is measured

  // A joint that slides is found from a height by a linear equation.
  bool has_two_roots(const SerialChain& chain) const {
    return equation != Equation::vector && (chain.axis(joint).turns || equation != Equation::height);
  }
};

// By joint of the chain, freedoms last: whether it is known.
using Known = std::vector<bool>;

// All steps that may find one more joint.
std::vector<Step> possible_steps(const SerialChain& chain, const std::vector<Feature>& features, const Known& known);

// `J4: distance of the point of J1, J2, J3 and the point of J5, J6, 2 roots`
std::string describe(const SerialChain& chain, const Step& step);
// `the point of J5, J6`; `the base`, `the target`
std::string describe(const SerialChain& chain, const Feature& feature);

}  // namespace robcogen::algorithm::inversion
