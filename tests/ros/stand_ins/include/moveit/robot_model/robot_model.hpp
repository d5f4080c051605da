// Stand-in for robot models of MoveIt: what a kinematics plugin asks them, with values that tests set.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace moveit::core {

struct VariableBounds {
  double min_position_ = 0, max_position_ = 0;
  bool position_bounded_ = false;
};

class JointModelGroup {
 public:
  explicit JointModelGroup(std::vector<std::string> variables) : variables_(std::move(variables)) {}
  const std::vector<std::string>& getVariableNames() const { return variables_; }

 private:
  std::vector<std::string> variables_;
};

class RobotModel {
 public:
  urdf::ModelInterfaceSharedPtr urdf;
  std::map<std::string, JointModelGroup> groups;
  std::map<std::string, VariableBounds> bounds;

  const urdf::ModelInterfaceSharedPtr& getURDF() const { return urdf; }
  const JointModelGroup* getJointModelGroup(const std::string& name) const {
    const auto at = groups.find(name);
    return at == groups.end() ? nullptr : &at->second;
  }
  const VariableBounds& getVariableBounds(const std::string& variable) const { return bounds.at(variable); }
};

}  // namespace moveit::core
