// Finds frames that a document names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

template <class Element>
std::vector<std::string> names_of(const std::vector<Element>& elements) {
  std::vector<std::string> names;
  for (const Element& element : elements) names.push_back(element.name);
  return names;
}

// Returns a pair of frames, both of which must exist.
FramePair frame_pair(const KinematicTree& tree, const std::string& left, const std::string& right);

// Finds a frame. If the robot has no such frame, reports an error with this code and suggests a similar name.
std::optional<Frame> find_named_frame(
    const KinematicTree& tree,
    const std::string& name,
    const Place& place,
    const std::string& code,
    Diagnostics& diagnostics);

}  // namespace robcogen::model
