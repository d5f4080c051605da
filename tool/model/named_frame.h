// Frames and joints that clauses of a document name.
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

// Of frames that the robot has.
FramePair frame_pair(const KinematicTree& tree, const std::string& left, const std::string& right);

// Reports an error of this code where the robot has no such frame, and suggests a similar one.
std::optional<Frame> find_named_frame(
    const KinematicTree& tree,
    const std::string& name,
    const Place& place,
    const std::string& code,
    Diagnostics& diagnostics);

}  // namespace robcogen::model
