#include "backend/common/identity.h"

namespace robcogen::backend {

std::string identity(const Library& library) {
  std::string text = library.model_hash + (library.tree.uses_passive_forces ? " passive forces" : "");
  for (const model::ContactFrame& c : library.contacts)
    text += " " + c.frame.name + (c.is_surface ? " surface" : " point");
  if (!library.parameters().empty())
    for (const std::string& group : library.groups) text += " " + group;
  return hash_text(text);
}

std::string group_of_identity(const Library& library) {
  return library.has_robot() ? "parameters" : "transforms";
}

}  // namespace robcogen::backend
