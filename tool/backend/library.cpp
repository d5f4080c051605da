#include "backend/library.h"

namespace robcogen::backend {

std::vector<std::string> Library::frames() const {
  return has_robot() ? model::frame_names(tree) : model::motions_of(document).frames;
}

bool is_kinematics(const std::string& group) {
  for (const char* word : {"transforms", "jacobian", "velocities", "accelerations"})
    if (group.starts_with(word)) return true;
  return false;
}

}  // namespace robcogen::backend
