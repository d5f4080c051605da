// The elements of URDF 1.x and URDF+, and those of other programs, with what is known about their effect.
#pragma once

#include <string>
#include <vector>

namespace robcogen::import::from_urdf {

struct KnownElement {
  std::vector<std::string> required;        // attributes that must be there
  std::vector<std::string> optional;        // further attributes that are read, or reported where they have an effect
  std::vector<std::string> without_effect;  // attributes that change neither kinematics nor dynamics
  std::vector<std::string> children_without_effect;

  bool has(const std::string& attribute) const;
};

// Returns nullptr for an element that is not read.
const KnownElement* known_element(const std::string& name);

// Whether an element of this name in an element that is read is known to change neither kinematics nor dynamics.
bool is_without_effect(const std::string& child, const std::string& parent);

}  // namespace robcogen::import::from_urdf
