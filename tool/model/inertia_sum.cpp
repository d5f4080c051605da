#include <cstddef>
#include <optional>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

std::optional<Inertia> sum_of(const std::vector<Inertia>& parts) {
  if (parts.empty()) return std::nullopt;
  RigidBodyInertia sum;
  Inertia result;
  for (const Inertia& part : parts) {
    sum = sum + in_link_frame(part);
    result.com = part.reference->translation;
  }
  result.mass = sum.mass;
  if (parts.size() > 1) {
    for (std::size_t k = 0; k < 3; ++k)
      result.com[k] = sum.mass.is_zero() ? Quantity() : sum.first_moment[k] / sum.mass;
  }
  result.ixx = sum.ixx, result.iyy = sum.iyy, result.izz = sum.izz;
  result.ixy = sum.ixy, result.ixz = sum.ixz, result.iyz = sum.iyz;
  return result;
}

}  // namespace robcogen::model
