#include "import/coupled_joints.h"

#include <fmt/format.h>

#include "import/kinematics.h"

namespace robcogen::import {

CoupledJoints::CoupledJoints(const language::kinematics::Document& document) {
  for (const language::kinematics::Joint& joint : document.joints) {
    const auto compound = compound_type_of(joint.type);
    if (!compound) {
      turns_.insert({joint.name.text, model::turns(type_of(joint.type))});
      continue;
    }
    std::string& coordinates = coordinates_[joint.name.text];
    for (const model::CompoundCoordinate& coordinate : model::coordinates_of(*compound)) {
      const std::string name = model::coordinate_name(joint.name.text, coordinate);
      turns_.insert({name, model::turns(coordinate.type)});
      coordinates += fmt::format("{}'{}'", coordinates.empty() ? "" : ", ", name);
    }
  }
}

std::optional<bool> CoupledJoints::turns(const std::string& name) const {
  const auto found = turns_.find(name);
  return found == turns_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace robcogen::import
