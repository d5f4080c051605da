// The elements of MJCF and their attributes, as of MuJoCo 3.14, with those of older versions.
#pragma once

#include <string>
#include <vector>

namespace robcogen::import::from_mjcf {

struct KnownElement {
  std::vector<std::string> read;  // attributes that this generator reads, or reports where they have an effect
  std::vector<std::string> without_effect;  // attributes that change neither kinematics nor dynamics
  std::vector<std::string> children;        // elements in it

  bool has(const std::string& attribute) const;
};

// `kind` is the name of an element or, where its attributes depend on where it is, a path: `default/equality`,
// `equality/joint`, `actuator` for all actuators, `tendon` for all tendons. Returns nullptr for elements that have no
// effect with any content, such as sensors, and for unknown ones.
const KnownElement* known_element(const std::string& kind);

}  // namespace robcogen::import::from_mjcf
