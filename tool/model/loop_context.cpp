#include "model/loop_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/index.h"

namespace robcogen::model {

const std::string& LoopContext::name(int joint) const {
  return tree.joints[at(joint)].name;
}

std::string LoopContext::quoted(const std::vector<int>& joints) const {
  std::string text;
  for (std::size_t k = 0; k < joints.size(); ++k)
    text += (k == 0 ? "'" : k + 1 == joints.size() ? " and '" : ", '") + name(joints[k]) + "'";
  return text;
}

bool LoopContext::is_free(int joint) const {
  const JointType type = tree.joints[at(joint)].type;
  return (type == JointType::revolute || type == JointType::prismatic) && !given.contains(joint) &&
         !independent.contains(joint);
}

bool LoopContext::is_driven(int joint) const {
  const Joint& j = tree.joints[at(joint)];
  return j.drive.has_inertia() || std::isfinite(j.limits.effort);
}

std::string LoopContext::hint_to_free(const std::vector<int>& joints) const {
  std::vector<int> kept;
  for (const int joint : joints)
    if (independent.contains(joint)) kept.push_back(joint);
  return kept.empty() ? ""
                      : fmt::format("leave {}{} out of 'independent'", kept.size() > 1 ? "one of " : "", quoted(kept));
}

void LoopContext::report(const LoopJoint& loop, const PlaneFault& fault) {
  diagnostics.error(fault.code, loop.place, fault.message).hint = fault.hint;
}

std::vector<int> joints_of(const LoopJoint& loop) {
  std::vector<int> joints = loop.ends[0].joints;
  joints.insert(joints.end(), loop.ends[1].joints.begin(), loop.ends[1].joints.end());
  return joints;
}

}  // namespace robcogen::model
