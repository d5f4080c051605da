// Finds frames and joints of inverse kinematics by name.
#include <fmt/format.h>

#include <map>
#include <utility>

#include "import/kinematics.h"
#include "model/named_frame.h"

namespace robcogen::import {
namespace {

// Whether a chain may have this tolerance.
bool is_tolerance(const NamedInverse& inverse, Diagnostics& diagnostics) {
  constexpr double kMost = 0.1;
  const double tolerance = *inverse.tolerance;
  if (tolerance > 0.0 && tolerance <= kMost) return true;
  diagnostics
      .error(
          "wrong-tolerance", inverse.place,
          fmt::format("the tolerance {} is not above 0 and at most {}", tolerance, kMost))
      .hint = "it is an angle (rad), and a length per metre of reach: 1e-3 for calibrated arms";
  return false;
}

}  // namespace

std::vector<model::InverseTarget> inverse_targets(
    const std::vector<NamedInverse>& names,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics) {
  std::map<std::pair<std::string, std::string>, Place> seen;
  std::vector<model::InverseTarget> targets;
  for (const NamedInverse& inverse : names) {
    const auto frame = [&](const std::string& name) {
      return model::find_named_frame(tree, name, inverse.place, "unknown-inverse-frame", diagnostics);
    };
    const auto left = frame(inverse.left), right = frame(inverse.right);
    if (!left || !right) continue;
    const auto [earlier, is_new] = seen.insert({{inverse.left, inverse.right}, inverse.place});
    if (!is_new) {
      diagnostics
          .error(
              "repeated-inverse", inverse.place,
              fmt::format("inverse kinematics from '{}' to '{}' is listed twice", inverse.left, inverse.right))
          .notes.push_back({earlier->second, "first listed here"});
      continue;
    }
    model::InverseTarget target{{*left, *right}, {inverse.kind, -1, inverse.by_swivel}, inverse.place};
    if (!inverse.given.empty()) {
      const std::optional<int> joint = tree.find_joint(inverse.given);
      if (!joint) {
        diagnostics
            .error(
                "unknown-given-joint", inverse.place,
                fmt::format("robot '{}' has no joint '{}'", tree.name, inverse.given))
            .hint = did_you_mean(inverse.given, model::names_of(tree.joints));
        continue;
      }
      target.task.given = *joint;
    }
    if (inverse.tolerance && !is_tolerance(inverse, diagnostics)) continue;
    target.task.tolerance = inverse.tolerance.value_or(0.0);
    targets.push_back(std::move(target));
  }
  return targets;
}

}  // namespace robcogen::import
