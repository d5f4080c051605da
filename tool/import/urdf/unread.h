// Finds mechanics in elements that are not read: visuals, collisions, and the sections of simulators.
#pragma once

#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

// What is not read, once for each kind, in the order of the text.
struct Unread {
  Span span;  // the first one
  std::string code, message, hint;
  int count = 0;
};

// Appends elements in `element` that affect the dynamics: mass properties in a visual or a collision, and in `gazebo`
// and `mujoco` springs, missing gravity, joints, links, and settings that change masses.
void find_mechanics(const Element& element, const Source& source, std::vector<Unread>& found);

// Appends a finding, or counts it if its message is known.
void add(Unread finding, std::vector<Unread>& found);

}  // namespace robcogen::import::from_urdf
