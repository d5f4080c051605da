// The elements of SDF 1.4 to 1.12 and their attributes, with what is known about their effect.
#pragma once

#include <string>

#include "import/xml/known_element.h"

namespace robcogen::import::from_sdf {

using xml::KnownElement;

// `kind` is the name of an element or, where its content depends on where it is, a path: `inertial/pose`. Returns
// nullptr for elements that are not read.
const KnownElement* known_element(const std::string& kind);

// What a plugin does to the dynamics of a model, by its file and name. `forces`: it adds forces that depend on the
// state of the robot.
enum class PluginEffect { none, forces, unknown };
PluginEffect effect_of_plugin(const std::string& file, const std::string& name);

}  // namespace robcogen::import::from_sdf
