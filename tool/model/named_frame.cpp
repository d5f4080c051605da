#include "model/named_frame.h"

#include <fmt/format.h>

namespace robcogen::model {

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
