#include "import/urdf/elements.h"

#include <map>

#include "support/words.h"

namespace robcogen::import::from_urdf {

namespace {

struct Row {
  const char* name;
  const char* required;
  const char* optional;
  const char* without_effect;
  const char* children_without_effect;
};

constexpr Row kRows[] = {
    {"robot", "", "name version", "",
     "actuator color controller drake:collision_filter_group drake:relative_pose_in_model frame gazebo gripper group "
     "material mujoco plugin ros2_control self_collision_checking sensor transmission velocity"},
    {"link", "name", "", "type",
     "collision collision_checking color contact frame gazebo gravity kinematic material plugin "
     "self_collision_checking sensor surface "
     "verbose visual"},
    {"inertial", "", "", "", "verbose"},
    {"mass", "value", "", "", ""},
    // The second triangle of the symmetric tensor says nothing new.
    {"inertia", "ixx iyy izz ixy ixz iyz", "", "iyx izx izy", ""},
    {"joint", "name type", "independent assembled", "dont_collapse",
     "actuator calibration controller_gains drake:controller_gains hardwareInterface material physics "
     "safety_controller sensor traits verbose"},
    {"origin", "", "xyz rpy quat_xyzw", "", ""},
    {"parent", "link", "", "", ""},
    {"child", "link", "", "", ""},
    {"axis", "xyz", "", "", ""},
    {"limit", "effort velocity", "lower upper",
     "acceleration deceleration drake:acceleration drake:jerk jerk soft_lower_limit soft_upper_limit", ""},
    {"dynamics", "",
     "armature damping friction gear_ratio rotor_inertia spring_rest spring_reference spring_stiffness stiffness", "",
     ""},
    {"mimic", "joint", "multiplier offset", "", ""},
    {"elastic", "stiffness", "damping", "", ""},
    {"loop", "name type", "", "", ""},
    {"coupling", "name", "", "", ""},
    {"predecessor", "link", "", "", ""},
    {"successor", "link", "", "", ""},
    {"ratio", "value", "", "", ""},
    // Shapes, where they are read.
    {"visual", "", "", "name", "material verbose"},
    {"collision", "", "", "name",
     "contact contact_coefficients drake:proximity_properties material max_contacts surface "
     "verbose"},
    {"geometry", "", "", "name", "verbose"},
    {"sphere", "radius", "", "", ""},
    {"box", "size", "", "", ""},
    {"cylinder", "radius length", "", "", ""},
    {"capsule", "radius length", "", "", ""},
    {"mesh", "filename", "scale", "", "drake:declare_convex"},
};

std::map<std::string, KnownElement> table() {
  std::map<std::string, KnownElement> result;
  for (const Row& row : kRows)
    result[row.name] = {
        words(row.required), words(row.optional), words(row.without_effect), words(row.children_without_effect)};
  return result;
}

}  // namespace

bool KnownElement::has(const std::string& attribute) const {
  return is_among(required, attribute) || is_among(optional, attribute) || is_among(without_effect, attribute);
}

const KnownElement* known_element(const std::string& name) {
  static const std::map<std::string, KnownElement> known = table();
  const auto found = known.find(name);
  return found == known.end() ? nullptr : &found->second;
}

bool is_without_effect(const std::string& child, const std::string& parent) {
  const KnownElement* known = known_element(parent);
  return known != nullptr && is_among(known->children_without_effect, child);
}

}  // namespace robcogen::import::from_urdf
