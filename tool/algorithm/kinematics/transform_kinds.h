// The forms of coordinate transforms in the API: one scope for each form.
#pragma once

#include <string>
#include <vector>

#include "algorithm/kinematics/kinematics.h"

namespace robcogen::algorithm {

struct TransformKind {
  TransformForm form;
  std::string scope;  // homogeneous, motion, force
  std::string shape;  // `4 x 4 homogeneous transform`

  std::string summary(const std::string& left, const std::string& right) const {
    return shape + ": maps coordinates in " + right + " to coordinates in " + left + ".";
  }
};

inline std::vector<TransformKind> transform_kinds() {
  return {
      {TransformForm::homogeneous, "homogeneous", "4 x 4 homogeneous transform"},
      {TransformForm::spatial_motion, "motion", "6 x 6 transform of spatial motion vectors, angular first"},
      {TransformForm::spatial_force, "force", "6 x 6 transform of spatial force vectors, moment first"}};
}

}  // namespace robcogen::algorithm
