// Replaces parameters by constants, and reports names that neither joints nor parameters have.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "model/locked_joints.h"
#include "model/named_frame.h"
#include "model/quantities.h"
#include "support/wildcards.h"

namespace robcogen::model {
namespace {

// Reports a name or pattern that no joint has. `or_parameter`: nor any parameter.
void report_unknown(
    const NamePattern& name,
    const Description& description,
    bool or_parameter,
    Diagnostics& diagnostics) {
  std::vector<std::string> names = names_of(description.joints);
  const bool is_name = !has_wildcards(name.text);
  if (is_name && or_parameter)
    for (const Parameter& p : description.parameters) names.push_back(p.name);
  Diagnostic& error = diagnostics.error(
      "lock-unknown", name.place,
      is_name ? fmt::format(
                    "robot '{}' has no joint{} '{}'", description.name,
                    or_parameter && !description.parameters.empty() ? " or parameter" : "", name.text)
              : fmt::format("no joint of robot '{}' matches '{}'", description.name, name.text));
  if (is_name) {
    error.hint = did_you_mean(name.text, names);
    const std::string coordinates = name.text + "_*";
    if (std::any_of(names.begin(), names.end(), [&](const std::string& n) { return matches(coordinates, n); }) &&
        error.hint.empty())
      error.hint = fmt::format("'{}' names its coordinates", coordinates);
  } else if (const std::string similar = nearest_to_pattern(name.text, names); !similar.empty()) {
    error.hint = fmt::format("should it match '{}'?", similar);
  }
  if (!error.hint.empty()) return;
  constexpr std::size_t kShown = 12;
  if (names.size() > kShown) {
    names.resize(kShown);
    names.emplace_back("…");
  }
  error.hint = fmt::format("its joints are {}", fmt::join(names, ", "));
}

bool names_joint(const NamePattern& name, const Description& description) {
  return std::any_of(description.joints.begin(), description.joints.end(), [&](const DescribedJoint& joint) {
    return matches(name.text, joint.name);
  });
}

}  // namespace

void lock_parameters(Description& description, const Changes& changes, Diagnostics& diagnostics) {
  std::vector<Quantity> values;
  for (std::size_t i = 0; i < description.parameters.size(); ++i)
    values.push_back(Quantity::parameter(static_cast<int>(i)));
  bool has_locked = false;
  for (const Lock& lock : changes.locks) {
    if (names_joint(lock.name, description)) continue;
    const auto found = std::find_if(
        description.parameters.begin(), description.parameters.end(),
        [&](const Parameter& p) { return p.name == lock.name.text; });
    if (found == description.parameters.end()) {
      report_unknown(lock.name, description, true, diagnostics);
    } else if (lock.quaternion) {
      diagnostics.error(
          "lock-parameter", lock.name.place, fmt::format("the value of parameter '{}' is a number", found->name));
    } else {
      values[static_cast<std::size_t>(found - description.parameters.begin())] = lock.position;
      has_locked = true;
    }
  }
  for (const NamePattern& name : changes.kept)
    if (!names_joint(name, description)) report_unknown(name, description, false, diagnostics);
  if (!has_locked) return;
  visit_quantities(description, [&](Quantity& q) { q = with_parameters(q, values); });
  remove_unused_parameters(description);
}

}  // namespace robcogen::model
