// The elements of MJCF and their attributes, as of MuJoCo 3.14, with those of older versions.
#pragma once

#include <string>

#include "import/xml/known_element.h"

namespace robcogen::import::from_mjcf {

using xml::KnownElement;

// `kind` is the name of an element or, where its attributes depend on where it is, a path: `default/equality`,
// `equality/joint`, `actuator` for all actuators, `tendon` for all tendons. Returns nullptr for elements that have no
// effect with any content, such as sensors, and for unknown ones.
const KnownElement* known_element(const std::string& kind);

}  // namespace robcogen::import::from_mjcf
