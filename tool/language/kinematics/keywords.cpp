#include "language/kinematics/keywords.h"

#include <algorithm>

namespace robcogen::language::kinematics {

const std::vector<std::string>& keywords() {
  static const std::vector<std::string> words = {
      "Robot",
      "RobotBase",
      "floating",
      "link",
      "id",
      "inertia_params",
      "inertia_properties",
      "mass",
      "CoM",
      "Ix",
      "Iy",
      "Iz",
      "Ixy",
      "Ixz",
      "Iyz",
      "ref_frame",
      "children",
      "via",
      "frames",
      "translation",
      "rotation",
      "r_joint",
      "p_joint"};
  return words;
}

bool is_keyword(const std::string& word) {
  return std::find(keywords().begin(), keywords().end(), word) != keywords().end();
}

}  // namespace robcogen::language::kinematics
