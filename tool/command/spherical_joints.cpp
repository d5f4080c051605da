#include "command/spherical_joints.h"

#include <fmt/format.h>

#include "command/output.h"
#include "support/diagnostics.h"
#include "support/index.h"

namespace robcogen::command {

void refuse_spherical_joints(const model::KinematicTree& tree, const std::string& reason, const std::string& hint) {
  const std::vector<int> spherical = tree.spherical_joints();
  if (spherical.empty()) return;
  const model::Joint& joint = tree.joints[at(spherical.front())];
  Diagnostic error;
  error.code = "spherical-joint";
  error.message = fmt::format("{}: joint '{}' of robot '{}' is spherical", reason, joint.spherical, tree.name);
  error.place = joint.place;
  error.hint = hint;
  std::string text = render(error);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  throw Failure{wrong_input, std::move(text)};
}

}  // namespace robcogen::command
