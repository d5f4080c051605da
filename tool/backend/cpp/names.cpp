#include "backend/cpp/names.h"

#include <cctype>
#include <string_view>

namespace robcogen::backend::cpp {
namespace {

// Names of the namespace of a robot that are not those of its functions: of namespaces and functions, and of types.
// Each stands between blanks.
constexpr std::string_view kNames =
    " accelerations batch core detail f32 flat here inertia_factor jacobians joint_trigonometry kernel "
    "limbs parameters reflection robot transforms update_both update_dynamics update_kinematics "
    "velocities world ";

constexpr std::string_view kTypes =
    " BasePose CoupledJoint DynamicsParameters DynamicsValues Frame GeneralizedAcceleration "
    "GeneralizedForce Gravity InertiaFactor InertiaMatrix InverseDynamics Joint JointPositions "
    "JointState JointTrigonometry JointVector KinematicsParameters KinematicsValues Limb Link "
    "LinkWrenches Matrix ParameterArray ParameterValues Parameters Position PositionVector Robot Scalar "
    "SharedValues SpatialAcceleration Twist Variable Vector3 Wrench ";

bool is_in(std::string_view list, const std::string& name) {
  return list.find(" " + name + " ") != std::string_view::npos;
}

bool begins_like_constant(const std::string& name) {
  return name.size() > 1 && name[0] == 'k' && std::isupper(static_cast<unsigned char>(name[1])) != 0;
}

}  // namespace

bool is_reserved_namespace(const std::string& name) {
  return name == "std" || name == "Eigen" || name == "robcogen" || is_reserved(name) || c_family::is_global(name);
}

std::string name_of_structure(const std::string& function) {
  std::string name;
  bool begins = true;
  for (const char c : function) {
    if (c != '_') name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '_';
  }
  return name;
}

bool is_taken(const std::string& function) {
  const std::string structure = name_of_structure(function);
  return begins_like_constant(function) || is_in(kNames, function) || is_in(kTypes, function) ||
         is_in(kTypes, structure) || structure.starts_with("Basic");
}

}  // namespace robcogen::backend::cpp
