#include "algorithm/catalogue/overloads.h"

#include <algorithm>

namespace robcogen::algorithm {

void add_method(std::vector<RobotFunction>& list, const std::string& name, const std::string& method) {
  if (method.empty()) return;
  for (RobotFunction& f : list)
    if (f.name == name) f.method = method;
}

void add_overloads(
    std::vector<RobotFunction>& list,
    const model::KinematicTree& tree,
    const std::string& group,
    const std::string& name,
    std::vector<std::string> summary,
    const Build& build,
    bool takes_external) {
  const auto add = [&](Loads loads, const std::string& suffix, const std::string& remark) {
    std::vector<std::string> lines = summary;
    lines.push_back(remark);
    const std::string kernel = name + suffix;
    list.push_back({group, "", name, std::move(lines), {}, {}, build(kernel, loads)});
  };
  if (!tree.floating_base) add(Loads::standard_gravity, "", "Gravity is (0, 0, -9.81) m/s^2 in base coordinates.");
  add(Loads::gravity, tree.floating_base ? "" : "_gravity", "`gravity` (m/s^2) is in base coordinates.");
  if (takes_external)
    add(Loads::gravity_and_external, "_external",
        "`gravity` (m/s^2) is in base coordinates; `external` is the wrench on each link, in link coordinates about "
        "the link's origin.");
}

Loads loads_of(const symbolic::Program& program) {
  const auto has = [&](symbolic::Role role) {
    return std::any_of(
        program.inputs.begin(), program.inputs.end(), [&](const auto& input) { return input.role == role; });
  };
  if (has(symbolic::Role::link_wrenches)) return Loads::gravity_and_external;
  return has(symbolic::Role::gravity) ? Loads::gravity : Loads::standard_gravity;
}

void add_wrenches_remark(std::vector<RobotFunction>& list) {
  list.back().summary.emplace_back("The wrenches are constant in these coordinates: they move with their links.");
}

}  // namespace robcogen::algorithm
