# robcogen_add_ros_plugins: plugins for ROS 2 over a robot.
#
#     robcogen_add_ros_plugins(
#       ROBOT arm                   # a target that robcogen_add_robot made in C++
#       [INTERFACES interface…]     # kinematics_interface, inverse_dynamics_solver, moveit: these, which must be found; without
#                                   # it, those whose package is found
#       [INVERSE_KINEMATICS left:right[:point|:axis|:swivel|:given=joint][:tolerance=number]…]
#                                   # chains for moveit; without it, those of robcogen_add_robot. Needed if DESIRED lists them
#       [PACKAGE name]              # without it, the name of the project
#       [NO_INSTALL])               # neither the libraries nor their descriptions are installed
#
# Makes a shared library for each interface, and installs it with its description for pluginlib and the entry of ament's
# index. For ROBOT arm in the package my_arm:
#
#     target and library            class that a configuration names        package of the interface
#     arm_kinematics_interface      my_arm/arm_kinematics_interface         kinematics_interface
#     arm_inverse_dynamics_solver   my_arm/arm_inverse_dynamics_solver      inverse_dynamics_solver
#     arm_moveit                    my_arm/arm_moveit                       moveit_core
#
# Without these packages nothing is made, so that a project builds without ROS, too.
include_guard(GLOBAL)

function(robcogen_add_ros_plugins)
  cmake_parse_arguments(PARSE_ARGV 0 library "NO_INSTALL" "ROBOT;PACKAGE" "INTERFACES;INVERSE_KINEMATICS")
  set(library_CALL robcogen_add_ros_plugins)
  set(library_TARGET "")
  _robcogen_refuse_repeated("ROBOT;PACKAGE" ${ARGV})
  _robcogen_check_parsed(ROBOT INTERFACES INVERSE_KINEMATICS PACKAGE NO_INSTALL)
  set(interfaces kinematics_interface inverse_dynamics_solver moveit)
  _robcogen_check_elements(INTERFACES ${interfaces})
  if("${library_ROBOT}" STREQUAL "")
    _robcogen_refuse("ROBOT is missing")
  endif()
  set(groups "")
  if(TARGET ${library_ROBOT})
    get_target_property(groups ${library_ROBOT} ROBCOGEN_GROUPS)
  endif()
  if(NOT groups)
    _robcogen_refuse("ROBOT: '${library_ROBOT}' is not a target that robcogen_add_robot made in C++")
  endif()
  if("${library_PACKAGE}" STREQUAL "")
    set(library_PACKAGE ${PROJECT_NAME})
  endif()
  get_target_property(chains ${library_ROBOT} ROBCOGEN_INVERSE_KINEMATICS)
  if("${library_INVERSE_KINEMATICS}" STREQUAL "" AND chains)
    set(library_INVERSE_KINEMATICS ${chains})
  endif()

  if("${library_INTERFACES}" STREQUAL "")
    set(library_INTERFACES ${interfaces})
    set(required OFF)
  else()
    set(required ON)
  endif()

  set(packages pluginlib rclcpp urdfdom)
  set(package_of_kinematics_interface kinematics_interface)
  set(package_of_inverse_dynamics_solver inverse_dynamics_solver)
  set(package_of_moveit moveit_core)
  foreach(package IN LISTS packages)
    find_package(${package} QUIET)
  endforeach()
  set(made "")
  set(missing "")
  foreach(interface IN LISTS library_INTERFACES)
    find_package(${package_of_${interface}} QUIET)
    _robcogen_check_packages(${interface} reason)
    if("${reason}" STREQUAL "")
      _robcogen_check_groups(${interface} reason)
    endif()
    if("${reason}" STREQUAL "")
      list(APPEND made ${interface})
      _robcogen_add_ros_plugin(${interface})
    elseif(required)
      _robcogen_refuse("${interface}: ${reason}")
    else()
      list(APPEND missing "${interface} (${reason})")
    endif()
  endforeach()
  list(JOIN made ", " made)
  list(JOIN missing ", " missing)
  if(NOT missing STREQUAL "")
    string(PREPEND missing "; not for ")
  endif()
  if(made STREQUAL "")
    set(made "none")
  endif()
  message(STATUS "${library_ROBOT}: plugins for ROS: ${made}${missing}")
endfunction()

# Sets `reason` to the packages of an interface that are not found.
function(_robcogen_check_packages interface reason)
  set(missing "")
  foreach(package ${package_of_${interface}} ${packages})
    if(NOT ${package}_FOUND)
      list(APPEND missing ${package})
    endif()
  endforeach()
  list(JOIN missing ", " missing)
  set(${reason} "" PARENT_SCOPE)
  if(NOT missing STREQUAL "")
    set(${reason} "not found: ${missing}" PARENT_SCOPE)
  endif()
endfunction()

# Sets `reason` to the groups of functions that the robot lacks for an interface.
function(_robcogen_check_groups interface reason)
  set(groups_of_kinematics_interface transforms jacobians)
  set(groups_of_inverse_dynamics_solver inverse_dynamics bias_forces joint_space_inertia transforms jacobians)
  set(groups_of_moveit inverse_kinematics transforms jacobians)
  set(missing ${groups_of_${interface}})
  list(REMOVE_ITEM missing ${groups})
  list(JOIN missing " " missing)
  set(${reason} "" PARENT_SCOPE)
  if(NOT missing STREQUAL "")
    set(${reason} "the robot has no ${missing}: see ALGORITHMS of robcogen_add_robot" PARENT_SCOPE)
  elseif(interface STREQUAL "moveit" AND "${library_INVERSE_KINEMATICS}" STREQUAL "")
    set(${reason} "INVERSE_KINEMATICS names no chain" PARENT_SCOPE)
  endif()
endfunction()

function(_robcogen_add_ros_plugin interface)
  set(target ${library_ROBOT}_${interface})
  if(TARGET ${target})
    _robcogen_refuse("a target with the name ${target} already exists")
  endif()
  foreach(property NAME NAMESPACE)
    get_target_property(library_${property} ${library_ROBOT} ROBCOGEN_${property})
    if(NOT library_${property})
      set(library_${property} "")
    endif()
  endforeach()
  _robcogen_folder(folder)
  _robcogen_header(${folder} reflection reflection)
  string(JOIN "::" robot ${library_NAMESPACE} ${library_NAME})
  set(header robcogen/ros/${interface}.h)
  set(base_package ${package_of_${interface}})
  set(solvers "")
  set(arguments "::${robot}::reflection::robot")
  if(interface STREQUAL "kinematics_interface")
    set(base kinematics_interface::KinematicsInterface)
    set(plugin "KinematicsInterface<::${robot}::Robot>")
  elseif(interface STREQUAL "inverse_dynamics_solver")
    set(base inverse_dynamics_solver::InverseDynamicsSolver)
    set(plugin "InverseDynamicsSolver<::${robot}::Robot>")
  else()
    set(header robcogen/ros/moveit_kinematics.h)
    set(base kinematics::KinematicsBase)
    _robcogen_ros_solvers(solvers names)
    list(JOIN names ", " names)
    set(plugin "MoveItKinematics<::${robot}::Robot, ${names}>")
    string(APPEND arguments ", ::${robot}::kJointTypes")
  endif()

  set(source ${CMAKE_CURRENT_BINARY_DIR}/robcogen.gen/${library_ROBOT}.ros/${interface}.cpp)
  # Names of classes are unique in a process, also where two packages have a robot of the same name.
  string(MAKE_C_IDENTIFIER "${library_PACKAGE}_plugins" namespace)
  string(MAKE_C_IDENTIFIER "${target}" class)
  file(
    CONFIGURE
    OUTPUT ${source}
    CONTENT "// The plugin of @robot@ for @interface@, by robcogen_add_ros_plugins.
#include <@folder@/@library_NAME@.h>
#include <@reflection@>

#include <pluginlib/class_list_macros.hpp>

#include \"@header@\"

namespace @namespace@ {
@solvers@
using @class@_base = robcogen::ros::@plugin@;

class @class@ : public @class@_base {
 public:
  @class@() : @class@_base(@arguments@) {}
};

}  // namespace @namespace@

PLUGINLIB_EXPORT_CLASS(@namespace@::@class@, @base@)
"
    @ONLY)
  set(description ${CMAKE_CURRENT_BINARY_DIR}/robcogen.gen/${library_ROBOT}.ros/${target}.xml)
  file(
    CONFIGURE
    OUTPUT ${description}
    CONTENT "<library path=\"@target@\">
  <class name=\"@library_PACKAGE@/@target@\" type=\"@namespace@::@class@\" base_class_type=\"@base@\">
    <description>Generated code of the robot @robot@</description>
  </class>
</library>
"
    @ONLY)

  add_library(${target} SHARED ${source})
  target_link_libraries(${target} PRIVATE ${library_ROBOT})
  target_compile_features(${target} PRIVATE cxx_std_17)
  target_include_directories(${target} SYSTEM PRIVATE ${urdfdom_INCLUDE_DIRS})
  target_link_libraries(${target} PRIVATE ${urdfdom_LIBRARIES})
  if(interface STREQUAL "moveit")
    _robcogen_link_ros(${target} moveit_core moveit_core::moveit_kinematics_base moveit_core::moveit_robot_model)
  else()
    _robcogen_link_ros(${target} ${interface} ${interface}::${interface})
  endif()
  foreach(package pluginlib rclcpp)
    _robcogen_link_ros(${target} ${package} ${package}::${package})
  endforeach()
  # Functions of the robot stay private: another plugin in the same process may have another robot of this name.
  if(CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
    target_link_options(${target} PRIVATE LINKER:--exclude-libs,ALL)
  endif()
  set_target_properties(${target} PROPERTIES FOLDER robots CXX_CLANG_TIDY "" UNITY_BUILD OFF)
  if(NOT library_NO_INSTALL)
    _robcogen_install_ros_plugin()
  endif()
endfunction()

# Links these targets of a package if it has them all, else what its variables name.
function(_robcogen_link_ros target package)
  foreach(library IN LISTS ARGN)
    if(NOT TARGET ${library})
      target_include_directories(${target} SYSTEM PRIVATE ${${package}_INCLUDE_DIRS})
      target_link_libraries(${target} PRIVATE ${${package}_LIBRARIES} ${${package}_TARGETS})
      return()
    endif()
  endforeach()
  target_link_libraries(${target} PRIVATE ${ARGN})
endfunction()

# Sets `text` to a struct for each chain of library_INVERSE_KINEMATICS, and `names` to their names.
function(_robcogen_ros_solvers text names)
  set(structs "")
  set(list "")
  foreach(chain IN LISTS library_INVERSE_KINEMATICS)
    if(NOT chain MATCHES "^([A-Za-z_][A-Za-z0-9_]*):([A-Za-z_][A-Za-z0-9_]*)(:(point|axis|swivel|given=([A-Za-z_][A-Za-z0-9_]*)))?(:tolerance=[0-9.eE+-]+)?$")
      _robcogen_refuse("INVERSE_KINEMATICS: '${chain}' is not left:right, with :point, :axis, :swivel or :given=joint, then :tolerance=1e-3")
    endif()
    set(left ${CMAKE_MATCH_1})
    set(right ${CMAKE_MATCH_2})
    set(given "${CMAKE_MATCH_5}")
    set(task pose)
    if("${CMAKE_MATCH_4}" MATCHES "^(point|axis|swivel)$")
      set(task ${CMAKE_MATCH_4})
    endif()
    set(function ${left}_X_${right})
    set(scope ::${robot}::inverse_kinematics)
    set(redundancy "")
    if(task STREQUAL "swivel")
      set(redundancy "
  template <class Positions>
  static auto redundancy(const Positions& q) {
    return ${scope}::redundancy::${function}(q);
  }")
    endif()
    list(APPEND list Solver_${function})
    string(APPEND structs "
struct Solver_${function} {
  static constexpr const char* kLeft = \"${left}\";
  static constexpr const char* kRight = \"${right}\";
  static constexpr const char* kGiven = \"${given}\";
  static constexpr auto kTask = robcogen::ros::Task::${task};
  static constexpr const auto& kJoints = ${scope}::${function}_joints;
  template <class... Arguments>
  static auto branches(const Arguments&... arguments) {
    return ${scope}::${function}(arguments...);
  }${redundancy}
};
")
  endforeach()
  set(${text} "${structs}" PARENT_SCOPE)
  set(${names} "${list}" PARENT_SCOPE)
endfunction()

# Installs the library `target`, its `description`, and the entry of the package in the index of `base_package`: one line for
# each description.
function(_robcogen_install_ros_plugin)
  install(TARGETS ${target} LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
  install(FILES ${description} DESTINATION share/${library_PACKAGE})
  set(key ROBCOGEN_ROS_${base_package}_${library_PACKAGE})
  set_property(GLOBAL APPEND_STRING PROPERTY ${key} "share/${library_PACKAGE}/${target}.xml\n")
  get_property(lines GLOBAL PROPERTY ${key})
  set(index ${PROJECT_BINARY_DIR}/robcogen.gen/ament_index/${base_package}__pluginlib__plugin/${library_PACKAGE})
  file(WRITE ${index} "${lines}")
  install(FILES ${index} DESTINATION share/ament_index/resource_index/${base_package}__pluginlib__plugin)
endfunction()
