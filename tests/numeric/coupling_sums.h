// Couplings as text, for expectations: `b = -1.0 a; c = 0.5 a 0.5 d; `.
#pragma once

#include <string>

#include "model/kinematic_tree.h"

namespace robcogen::test {

// One expression for each follower.
inline std::string sums(const model::KinematicTree& tree) {
  std::string text;
  for (const model::Coupling& coupling : tree.couplings) {
    text += tree.joints[static_cast<std::size_t>(coupling.joint)].name + " =";
    for (const model::Coupling::Term& term : coupling.terms)
      text += " " + model::print(term.factor, {}) + " " + tree.joints[static_cast<std::size_t>(term.joint)].name;
    text += "; ";
  }
  return text;
}

}  // namespace robcogen::test
