// The right-hand side of a coupling, or the length of a tendon: a sum of joints times constants, plus a constant.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "import/coupled_joints.h"
#include "import/parameters.h"

namespace robcogen::import {

// Powers of rad and m, if the document states a unit.
struct Dimension {
  int rad = 0, m = 0;
  bool is_said = false;

  friend bool operator==(const Dimension&, const Dimension&) = default;
};

// Multiplies dimension a by dimension b to the power of `sign`.
inline Dimension product(const Dimension& a, const Dimension& b, int sign) {
  return {a.rad + sign * b.rad, a.m + sign * b.m, a.is_said || b.is_said};
}

// The dimension of the position of a joint.
inline Dimension unit_of(bool turns) {
  return {turns ? 1 : 0, turns ? 0 : 1, true};
}

struct CouplingTerm {
  model::Quantity factor;
  Dimension unit;
  Span span;  // of the joint's name
};

struct CouplingSum {
  std::vector<std::pair<std::string, CouplingTerm>> terms;  // by joint name, in the order of the text
  model::Quantity offset;
  Dimension unit;  // of the offset

  bool is_constant() const { return terms.empty(); }
};

// Reads the sum. A plain name that is neither a joint nor a parameter stands for a joint, which the model reports.
// Returns nullopt after reporting a joint with several coordinates, an expression that is not linear in the joints, an
// undeclared name that is multiplied by a joint, or a division by zero.
std::optional<CouplingSum> read_coupling_sum(
    const language::kinematics::Coupling& coupling,
    const CoupledJoints& joints,
    QuantityReader& reader,
    Diagnostics& diagnostics);

// The same for the length of a tendon. Parameters in the constant are those of the dynamics.
std::optional<CouplingSum> read_length(
    const language::Expression& length,
    const CoupledJoints& joints,
    QuantityReader& reader,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
