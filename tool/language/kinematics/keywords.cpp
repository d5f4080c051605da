#include "language/kinematics/keywords.h"

#include <algorithm>
#include <array>
#include <utility>

#include "language/kinematics/document.h"

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

std::string_view keyword_of_joint(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kNames = {{
      {"revolute", "r_joint"},
      {"continuous", "r_joint"},
      {"hinge", "r_joint"},
      {"prismatic", "p_joint"},
      {"helical", "h_joint"},
      {"screw", "h_joint"},
      {"cylindrical", "c_joint"},
      {"universal", "u_joint"},
      {"planar", "planar_joint"},
      {"spherical", "s_joint"},
      {"ball", "s_joint"},
  }};
  for (const std::string_view ending : {"_joint", "joint", "Joint"}) {
    if (!word.ends_with(ending)) continue;
    word.remove_suffix(ending.size());
    break;
  }
  for (const auto& [name, keyword] : kNames)
    if (word == name) return keyword;
  return {};
}

std::string_view word_of(Joint::Type type) {
  switch (type) {
    case Joint::Type::revolute:
      break;
    case Joint::Type::prismatic:
      return "p_joint";
    case Joint::Type::helical:
      return "h_joint";
    case Joint::Type::cylindrical:
      return "c_joint";
    case Joint::Type::universal:
      return "u_joint";
    case Joint::Type::planar:
      return "planar_joint";
    case Joint::Type::spherical:
      return "s_joint";
  }
  return "r_joint";
}

std::span<const std::string_view> coordinate_words(Joint::Type type) {
  static constexpr std::array<std::string_view, 2> kCylindrical = {"slide", "turn"}, kUniversal = {"turn_x", "turn_z"};
  static constexpr std::array<std::string_view, 3> kPlanar = {"slide_x", "slide_y", "turn"};
  switch (type) {
    case Joint::Type::revolute:
    case Joint::Type::prismatic:
    case Joint::Type::helical:
    case Joint::Type::spherical:
      break;
    case Joint::Type::cylindrical:
      return kCylindrical;
    case Joint::Type::universal:
      return kUniversal;
    case Joint::Type::planar:
      return kPlanar;
  }
  return {};
}

}  // namespace robcogen::language::kinematics
