# Wrong calls; ../calls.cmake says how they are read.

#### ros_no_robot
# robcogen_add_ros_plugins(): ROBOT is missing
robcogen_add_ros_plugins(INTERFACES moveit)

#### ros_no_such_robot
# robcogen_add_ros_plugins(): ROBOT: 'arm' is not a target that robcogen_add_robot made in C++
robcogen_add_ros_plugins(ROBOT arm)

#### ros_unknown_interface
# robcogen_add_ros_plugins(): INTERFACES: 'kdl' is not one of kinematics_interface inverse_dynamics_solver moveit
robcogen_add_ros_plugins(ROBOT arm INTERFACES kdl)

#### ros_unknown_keyword
# robcogen_add_ros_plugins(): unknown argument 'SHARED'; the keywords are ROBOT INTERFACES INVERSE_KINEMATICS PACKAGE NO_INSTALL
robcogen_add_ros_plugins(ROBOT arm SHARED)

#### ros_robot_twice
# robcogen_add_ros_plugins(): ROBOT is given 2 times; it has one value
robcogen_add_ros_plugins(ROBOT arm ROBOT hyl)

#### ros_missing_package
# robcogen_add_ros_plugins(): moveit: not found: moveit_core, pluginlib, rclcpp, urdfdom
add_library(arm INTERFACE)
set_target_properties(arm PROPERTIES ROBCOGEN_GROUPS inverse_kinematics)
foreach(package moveit_core pluginlib rclcpp urdfdom)
  set(CMAKE_DISABLE_FIND_PACKAGE_${package} ON)
endforeach()
robcogen_add_ros_plugins(ROBOT arm INTERFACES moveit)
