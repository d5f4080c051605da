#include "import/coupled_joints.h"

#include <fmt/format.h>

#include <algorithm>

#include "import/kinematics.h"
#include "model/elastic_joints.h"

namespace robcogen::import {

CoupledJoints::CoupledJoints(const language::kinematics::Document& document) {
  const auto insert = [&](const std::string& name, model::JointType type, bool has_motor) {
    turns_.insert({name, model::turns(type)});
    if (has_motor) turns_.insert({model::motor_name(name), model::turns(type)});
  };
  for (const language::kinematics::Joint& joint : document.joints) {
    const auto compound = compound_type_of(joint.type);
    if (!compound) {
      insert(joint.name.text, type_of(joint.type), joint.elasticity.has_value());
      continue;
    }
    std::string& coordinates = coordinates_[joint.name.text];
    for (const model::CompoundCoordinate& coordinate : model::coordinates_of(*compound)) {
      const std::string name = model::coordinate_name(joint.name.text, coordinate);
      const auto is_elastic = [&](const language::kinematics::Coordinate& c) {
        return c.word.text == coordinate.name && c.elasticity;
      };
      insert(name, coordinate.type, std::any_of(joint.coordinates.begin(), joint.coordinates.end(), is_elastic));
      coordinates += fmt::format("{}'{}'", coordinates.empty() ? "" : ", ", name);
    }
  }
}

std::optional<bool> CoupledJoints::turns(const std::string& name) const {
  const auto found = turns_.find(name);
  return found == turns_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace robcogen::import
