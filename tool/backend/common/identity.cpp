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

std::string name_of_model(const Library& library) {
  return "model_" + identity(library);
}

std::vector<std::string> identity_names(const Library& library, const std::string& group) {
  if (group != (library.has_robot() ? "parameters" : "transforms")) return {};
  return {name_of_model(library), "two_models_have_the_same_NAME_and_NAMESPACE"};
}

}  // namespace robcogen::backend
