// The joints that couplings and tendons may name.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "language/kinematics/document.h"

namespace robcogen::import {

// Joints with one coordinate, the coordinates of joints with several, which have names of their own, and the motors of
// elastic joints.
class CoupledJoints {
 public:
  explicit CoupledJoints(const language::kinematics::Document& document);

  bool contains(const std::string& name) const { return turns_.contains(name); }
  // Whether the joint or coordinate turns rather than slides. nullopt for an unknown name.
  std::optional<bool> turns(const std::string& name) const;

  // False for a joint with several coordinates.
  bool is_single(const std::string& joint) const { return !coordinates_.contains(joint); }
  // The coordinates of such a joint as text for messages: `'leg_x', 'leg_y'`.
  const std::string& coordinates_of(const std::string& joint) const { return coordinates_.at(joint); }

 private:
  std::map<std::string, bool> turns_;
  std::map<std::string, std::string> coordinates_;
};

}  // namespace robcogen::import
