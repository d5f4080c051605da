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

std::vector<double> LoopContext::start() const {
  return tree.assembled_positions(parameters);
}

bool LoopContext::has_start(const std::vector<int>& joints) const {
  return std::any_of(joints.begin(), joints.end(), [&](int joint) {
    const auto gives = [&](int other) { return tree.joints[at(other)].assembled_position() != 0.0; };
    const Coupling* coupling = tree.coupling_of(joint);
    if (coupling == nullptr || !coupling->is_linear()) return gives(joint);
    return std::any_of(
        coupling->terms.begin(), coupling->terms.end(), [&](const Coupling::Term& term) { return gives(term.joint); });
  });
}

std::string LoopContext::where(const std::vector<int>& joints) const {
  if (!has_start(joints)) return "at q = 0";
  return assembled_form == AssembledForm::key ? "in the pose of assembly" : "at the 'assembled' positions";
}

std::string LoopContext::assembled_text(double position) const {
  std::string number = fmt::format("{:.3g}", position);
  if (number.find_first_of(".e") == std::string::npos) number += ".0";
  return assembled_form == AssembledForm::attribute ? fmt::format("assembled=\"{}\"", number)
                                                    : fmt::format("assembled = {}", number);
}

std::string LoopContext::hint_to_close(const std::vector<int>& joints) const {
  if (assembled_form == AssembledForm::key) return "give the model a 'key' whose 'qpos' closes the loops";
  if (has_start(joints))
    return "independent joints are at their 'assembled' positions, or at zero: check lengths and frames";
  return std::string("loops are assembled with the independent joints at q = 0: check lengths and frames, or ") +
         (assembled_form == AssembledForm::none
              ? "turn the placement of a joint so that the loop closes"
              : fmt::format("give joints a position near which the loop closes, such as '{}'", assembled_text(0.5)));
}

std::string LoopContext::hint_to_assemble(const std::vector<int>& joints, const std::string& how) const {
  if (assembled_form == AssembledForm::key) return fmt::format("give the model a 'key' with a 'qpos' in which {}", how);
  if (has_start(joints)) return fmt::format("'assembled' must give positions near which {}", how);
  const std::string turned = fmt::format("turn the placement of a joint so that {} at q = 0", how);
  if (assembled_form == AssembledForm::none) return turned;
  return turned + fmt::format(", or give joints a position where {}, such as '{}'", how, assembled_text(0.5));
}

bool LoopContext::is_free(int joint) const {
  const JointType type = tree.joints[at(joint)].type;
  return (type == JointType::revolute || type == JointType::prismatic) && !given.contains(joint) &&
         !independent.contains(joint);
}

bool LoopContext::is_driven(int joint) const {
  const Joint& j = tree.joints[at(joint)];
  return driven.contains(joint) || j.drive.has_inertia() || std::isfinite(j.limits.effort);
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
