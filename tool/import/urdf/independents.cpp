// Determines which joints of loops are independent.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "import/urdf/loops.h"

namespace robcogen::import::from_urdf {

std::vector<bool> may_follow(const Document& document) {
  const bool has_followers = std::any_of(
      document.joints.begin(), document.joints.end(), [](const Joint& joint) { return joint.is_independent == false; });
  std::vector<bool> result;
  for (const Joint& joint : document.joints) result.push_back(!joint.is_independent.value_or(has_followers));
  return result;
}

void add_independents(
    const Document& document,
    const Identifiers& identifiers,
    const std::vector<bool>& may_follow,
    const std::set<int>& joints_of_loops,
    model::Description& description,
    Diagnostics& diagnostics) {
  std::set<std::string> coupled;
  for (const model::DescribedCoupling& coupling : description.couplings) coupled.insert(coupling.joint);
  for (std::size_t j = 0; j < document.joints.size(); ++j) {
    const Joint& joint = document.joints[j];
    const std::string& name = identifiers.joints[j];
    if (coupled.contains(name)) continue;
    const bool is_of_loop = joints_of_loops.contains(static_cast<int>(j));
    if (joint.is_independent == false && !is_of_loop)
      diagnostics.error(
          "independent-without-loop", joint.independent_place,
          fmt::format("joint '{}' is not independent, but no loop or coupling determines it", joint.name.text));
    if (is_of_loop && !may_follow[j] && is_movable(joint))
      description.independents.push_back({name, joint.is_independent ? joint.independent_place : joint.name.place});
  }
}

}  // namespace robcogen::import::from_urdf
