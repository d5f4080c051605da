#include "model/drive.h"

#include <cmath>

#include "model/kinematic_tree.h"

namespace robcogen::model {

std::array<Quantity, 3> rotor_axis(const Joint& joint) {
  if (!joint.drive.rotor->axis) {
    const auto R = rotation_matrix(joint.placement);
    return {R[0][2], R[1][2], R[2][2]};
  }
  const auto& [x, y, z] = *joint.drive.rotor->axis;
  const Quantity length = sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

double bounded(double limit) {
  return std::abs(limit) < kNoLimit ? limit : std::copysign(std::numeric_limits<double>::infinity(), limit);
}

}  // namespace robcogen::model
