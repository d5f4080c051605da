#include "algorithm/kinematics/all_joints.h"

namespace robcogen::algorithm {

using symbolic::Role;

std::vector<Expression> input_of_all_joints(
    Trace& trace,
    const model::KinematicTree& tree,
    const std::string& name,
    const std::vector<std::string>& others) {
  const std::vector<int> order = model::independent_joints_first(tree);
  std::vector<std::string> names;
  for (const int joint : order) names.push_back(tree.joints[at(joint)].name);
  names.insert(names.end(), others.begin(), others.end());
  const std::vector<Expression> given = trace.input(name, Role::value, names);
  std::vector<Expression> by_joint = given;
  for (std::size_t k = 0; k < order.size(); ++k) by_joint[at(order[k])] = given[k];
  return by_joint;
}

void output_of_all_joints(
    Trace& trace,
    const model::KinematicTree& tree,
    const std::string& name,
    const std::vector<Expression>& by_joint) {
  std::vector<Expression> values;
  for (const int joint : model::independent_joints_first(tree)) values.push_back(by_joint[at(joint)]);
  trace.output(name, Role::value, values);
}

}  // namespace robcogen::algorithm
