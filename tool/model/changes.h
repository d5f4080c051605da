// What a user changes in a robot before it is built: joints and parameters that become constant, and constants that
// become parameters.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/description.h"

namespace robcogen::model {

// A name, or a pattern (support/wildcards.h).
struct NamePattern {
  std::string text;
  Place place;
};

// Joints at a constant position, or a parameter with a constant value. A pattern names joints only.
struct Lock {
  NamePattern name;
  Quantity position;                                       // constant: rad, m, or the unit of a parameter
  std::optional<std::array<Quantity, 4>> quaternion = {};  // of a spherical joint, w x y z, instead of a position
};

struct Changes {
  std::vector<Lock> locks = {};        // of two that name one joint, the later one counts
  std::vector<NamePattern> kept = {};  // if there are any, all other joints are locked, at zero if no lock names them

  std::vector<NamePattern> parameters = {};  // quantities that become parameters: see parametrise.h

  bool has_locks() const { return !locks.empty() || !kept.empty(); }
  bool empty() const { return !has_locks() && parameters.empty(); }
};

// Changes the description, parameters first, then builds it like build(description, diagnostics). Links beyond locked
// joints become part of the links that carry them: masses are lumped, and their frames, and those of the joints, remain
// as user frames.
// - A joint that follows locked joints through couplings or loops is locked where they put it. A joint with a locked
//   follower is locked too, if the follower determines its position.
// - A loop whose other joints can still move is assembled near the locked position.
// Reports names that the robot does not have, positions beyond limits, loops that do not close, and placements that
// depend on parameters in a way that cannot be combined.
std::optional<KinematicTree> build(const Description& description, const Changes& changes, Diagnostics& diagnostics);

}  // namespace robcogen::model
