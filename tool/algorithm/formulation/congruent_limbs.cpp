#include "algorithm/formulation/congruent_limbs.h"

#include <algorithm>
#include <utility>

namespace robcogen::algorithm {
namespace {

using symbolic::Role;

bool is_by_joint(Role role) {
  return role == Role::joint_position || role == Role::joint_velocity || role == Role::joint_acceleration ||
         role == Role::joint_force;
}

}  // namespace

std::vector<LimbsInLanes> limbs_in_lanes(const model::KinematicTree& tree) {
  std::vector<LimbsInLanes> result;
  for (const model::LimbClass& limbs : model::limb_classes(tree)) {
    std::size_t first = 0;
    for (const std::size_t width : {8U, 4U, 2U}) {
      for (; first + width <= limbs.count(); first += width) {
        LimbsInLanes lanes;
        for (std::size_t k = 0; k < limbs.length(); ++k) {
          const std::vector<int> all = limbs.corresponding(k);
          const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
          lanes.joints.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(width));
        }
        for (const int joint : lanes.joints.front())
          lanes.names.push_back(tree.joints[static_cast<std::size_t>(joint)].name);
        result.push_back(std::move(lanes));
      }
    }
  }
  return result;
}

std::vector<std::vector<int>> limb_inputs(
    const model::KinematicTree& tree,
    const LimbsInLanes& limbs,
    const symbolic::Program& program) {
  constexpr int kWrench = 6;
  const std::vector<int> positions = tree.position_elements();
  std::vector<std::vector<int>> tuples;
  int begin = 0;
  for (const symbolic::InputArray& array : program.inputs) {
    const auto size = static_cast<int>(array.elements.size());
    for (const std::vector<int>& joints : limbs.joints) {
      const bool follow = tree.coupling_of(joints.front()) != nullptr;  // these joints have no coordinates
      if (follow && is_by_joint(array.role)) continue;
      if (array.role == Role::joint_position) {
        // The scalar part of a quaternion comes first.
        const model::Joint& first = tree.joints[static_cast<std::size_t>(joints.front())];
        for (int offset = !first.spherical.empty() && first.is_first() ? -1 : 0; offset <= 0; ++offset) {
          std::vector<int>& tuple = tuples.emplace_back();
          for (const int joint : joints) tuple.push_back(begin + positions[static_cast<std::size_t>(joint)] + offset);
        }
      } else if (is_by_joint(array.role) && size == tree.dof()) {
        std::vector<int>& tuple = tuples.emplace_back();
        for (const int joint : joints) tuple.push_back(begin + tree.coordinate_of(joint));
      }
      if (array.role != Role::link_wrenches) continue;
      const int first_child = tree.joints[static_cast<std::size_t>(joints.front())].child;
      if (tree.links[static_cast<std::size_t>(first_child)].is_repeated) continue;
      for (int k = 0; k < kWrench; ++k) {
        std::vector<int>& tuple = tuples.emplace_back();
        for (const int joint : joints)
          tuple.push_back(begin + kWrench * tree.joints[static_cast<std::size_t>(joint)].child + k);
      }
    }
    begin += size;
  }
  return tuples;
}

}  // namespace robcogen::algorithm
