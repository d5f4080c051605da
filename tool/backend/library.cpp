#include "backend/library.h"

namespace robcogen::backend {

std::vector<std::string> Library::frames() const {
  return has_robot() ? model::frame_names(tree) : model::motions_of(document).frames;
}

}  // namespace robcogen::backend
