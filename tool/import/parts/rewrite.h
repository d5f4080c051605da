// Copies the elements of a part for one instance: arguments replace parameters, and the copies have places of their
// own.
#pragma once

#include <map>
#include <set>
#include <string>

#include "import/parts/scope.h"
#include "language/common/expression.h"

namespace robcogen::import::parts {

// The meanings of names in the expressions of a part.
struct Meanings {
  std::map<std::string, language::ExpressionPtr> values = {};  // of parameters of the part
  std::set<std::string> joints = {};                           // which couplings may name
  // The name of a part, for messages. Empty for a robot, in which other names are parameters of the robot.
  std::string part = {};
};

// Returns the body with its offsets moved by `shift` into those of `source`. Reports names without a meaning.
kinematics::Body rewritten(
    kinematics::Body body,
    std::size_t shift,
    const Meanings& meanings,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics);

// Returns the names in the expressions of a robot that may be parameters.
std::set<std::string> parameters_of(const kinematics::Body& body);

}  // namespace robcogen::import::parts
