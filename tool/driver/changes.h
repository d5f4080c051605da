// The options that change a robot: --lock, --keep and --parameters.
#pragma once

#include <string>
#include <vector>

#include "model/changes.h"

namespace robcogen::driver {

// What was given to the options, as written.
struct ChangeOptions {
  std::vector<std::string> locks = {};  // `elbow = 0.3`, `hand_* = 0  wrist = PI/2`, `ball = (1, 0, 0, 0)`
  std::vector<std::string> kept = {};   // `arm_*`

  std::vector<std::string> parameters = {};  // `tool0.inertia`, `*.mass`

  bool empty() const { return locks.empty() && kept.empty() && parameters.empty(); }
};

// Reports what is not `name = value`. Places are in the text of the option.
model::Changes read_changes(const ChangeOptions& options, Diagnostics& diagnostics);

}  // namespace robcogen::driver
