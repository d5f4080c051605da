// The joints that couplings may name.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "language/kinematics/document.h"

namespace robcogen::import {

// Joints of one coordinate, and the coordinates of the others by their own names.
class CoupledJoints {
 public:
  explicit CoupledJoints(const language::kinematics::Document& document);

  bool contains(const std::string& name) const { return turns_.contains(name); }
  // Whether it turns; otherwise it slides. nullopt for an unknown name.
  std::optional<bool> turns(const std::string& name) const;

  // False for a joint of several coordinates.
  bool is_single(const std::string& joint) const { return !coordinates_.contains(joint); }
  // Of such a joint, for messages: `'leg_x', 'leg_y'`.
  const std::string& coordinates_of(const std::string& joint) const { return coordinates_.at(joint); }

 private:
  std::map<std::string, bool> turns_;
  std::map<std::string, std::string> coordinates_;
};

}  // namespace robcogen::import
