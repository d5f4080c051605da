// The elements of SDF 1.4 to 1.12 and their attributes, with what is known about their effect.
#pragma once

#include <string>
#include <vector>

namespace robcogen::import::from_sdf {

struct KnownElement {
  std::vector<std::string> attributes;
  std::vector<std::string> children;        // that this generator reads
  std::vector<std::string> without_effect;  // children that change neither kinematics nor dynamics
};

// `kind` is the name of an element or, where its content depends on where it is, a path: `inertial/pose`. Returns
// nullptr for elements that are not read.
const KnownElement* known_element(const std::string& kind);

// What a plugin does to the dynamics of a model, by its file and name. `forces`: it adds forces that depend on the state
// of the robot.
enum class PluginEffect { none, forces, unknown };
PluginEffect effect_of_plugin(const std::string& file, const std::string& name);

}  // namespace robcogen::import::from_sdf
