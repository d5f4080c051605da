#include "model/named_frame.h"

#include <fmt/format.h>

namespace robcogen::model {

FramePair frame_pair(const KinematicTree& tree, const std::string& left, const std::string& right) {
  return {tree.find_frame(left).value(), tree.find_frame(right).value()};
}

std::optional<Frame> find_named_frame(
    const KinematicTree& tree,
    const std::string& name,
    const Place& place,
    const std::string& code,
    Diagnostics& diagnostics) {
  std::optional<Frame> found = tree.find_frame(name);
  if (!found)
    diagnostics.error(code, place, fmt::format("robot '{}' has no frame '{}'", tree.name, name)).hint =
        did_you_mean(name, names_of(tree.frames()));
  return found;
}

}  // namespace robcogen::model
