# The package of robots/ros2 as a colcon workspace builds it: configured, built and installed on its own, then used by
# another package; without ROS and with stand-ins for the ROS packages that it looks for. If colcon is installed, it
# builds the workspace, too.
#
# cmake -D PREFIX=dir -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir -D VERSION=1.0.0 -P ros2.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(workspace ${WORK_DIR}/ros2)
file(REMOVE_RECURSE ${workspace})
file(COPY ${SOURCE_DIR}/robots/ros2/ DESTINATION ${workspace}/src/demo_arm_control)
file(READ ${SOURCE_DIR}/package.xml manifest)
expect_words("package.xml" "${manifest}" "<version>${VERSION}</version>")
file(READ ${SOURCE_DIR}/colcon.pkg colcon)
string(JSON count LENGTH "${colcon}" cmake-args)
expect_equal("arguments in colcon.pkg" ${count} 2)
foreach(file package.xml ament_index/resource_index/packages/robcogen)
  if(NOT EXISTS ${PREFIX}/share/robcogen/${file} AND NOT EXISTS ${PREFIX}/share/${file})
    message(FATAL_ERROR "robcogen installs no ${file}")
  endif()
endforeach()

# Stand-ins for the ROS packages that the plugin needs.
foreach(package controller_interface pluginlib)
  file(WRITE ${workspace}/ros/share/${package}/cmake/${package}Config.cmake
       "add_library(${package}::${package} INTERFACE IMPORTED)
        target_include_directories(${package}::${package} INTERFACE ${SOURCE_DIR}/tests/generic/ros2)")
endforeach()

set(prefix ${workspace}/install/demo_arm_control)
set(build_dir ${workspace}/build/demo_arm_control)
foreach(ros OFF ON)
  if(ros)
    set(ENV{CMAKE_PREFIX_PATH} ${workspace}/ros)
  endif()
  run(output ${CMAKE_COMMAND} -G Ninja -S ${workspace}/src/demo_arm_control -B ${build_dir} -DCMAKE_INSTALL_PREFIX=${prefix}
      -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_PREFIX_PATH=${PREFIX})
  run(output ${CMAKE_COMMAND} --build ${build_dir} --parallel 2)
  run(output ${CMAKE_COMMAND} --install ${build_dir})
  foreach(file share/demo_arm_control/package.xml share/ament_index/resource_index/packages/demo_arm_control
               lib/cmake/demo_arm_control/demo_arm_controlConfig.cmake include/demo_arm/demo_arm.h)
    if(NOT EXISTS ${prefix}/${file})
      message(FATAL_ERROR "${file} is not installed")
    endif()
  endforeach()
  set(index ${prefix}/share/ament_index/resource_index/controller_interface__pluginlib__plugin/demo_arm_control)
  if(EXISTS ${index} AND NOT ros)
    message(FATAL_ERROR "without ROS there is a plugin")
  endif()
endforeach()
run(output ${CMAKE_CTEST_COMMAND} --test-dir ${build_dir} --output-on-failure --no-tests=error -R selfcheck)
file(READ ${index} description)
string(STRIP "${description}" description)
foreach(file ${description} lib/libdemo_arm_control.so)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "${file} of the plugin is not installed")
  endif()
endforeach()

# A second package in the workspace, which uses the first.
file(WRITE ${workspace}/src/user/CMakeLists.txt "
  cmake_minimum_required(VERSION 3.22)
  project(user LANGUAGES CXX)
  find_package(demo_arm_control 1.0 REQUIRED)
  add_executable(user main.cpp)
  target_link_libraries(user PRIVATE demo_arm_control::demo_arm_controller)")
file(WRITE ${workspace}/src/user/main.cpp
     "#include <computed_torque_controller.h>
      #include <demo_arm/demo_arm.h>
      #include <demo_arm/reflection.h>
      #include <cstdio>
      int main() {
        demo_arm_control::ComputedTorqueController c(robcogen::make_any<demo_arm::Robot>(demo_arm::reflection::robot));
        for (const std::string& name : c.command_interfaces()) std::puts(name.c_str());
      }")
run(output ${CMAKE_COMMAND} -G Ninja -S ${workspace}/src/user -B ${workspace}/build/user -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
    -DCMAKE_PREFIX_PATH=${PREFIX} -Ddemo_arm_control_ROOT=${prefix})
run(output ${CMAKE_COMMAND} --build ${workspace}/build/user)
run(output ${workspace}/build/user/user)
expect_words("interfaces" "${output}" "shoulder_pan/effort shoulder_lift/effort elbow/effort")

find_program(colcon_program colcon)
if(NOT colcon_program)
  message(STATUS "not built by colcon (Debian: python3-colcon-cmake, python3-colcon-ros)")
  return()
endif()
file(WRITE ${workspace}/src/user/package.xml
     "<package format=\"3\"><name>user</name><version>1.0.0</version><description>A user</description>
      <maintainer email=\"robcogen@example.org\">RobCoGen developers</maintainer><license>BSD-3-Clause</license>
      <depend>demo_arm_control</depend><export><build_type>cmake</build_type></export></package>")
# A robot with plugins for interfaces of ROS, of which there are stand-ins.
file(COPY ${SOURCE_DIR}/robots/ros2_arm/ DESTINATION ${workspace}/src/ros2_arm)
file(REMOVE_RECURSE ${workspace}/build ${workspace}/install)
set(ENV{CMAKE_PREFIX_PATH} ${PREFIX}:${SOURCE_DIR}/tests/ros/stand_ins)
set(ENV{CXX} ${CXX_COMPILER})
run(output ${CMAKE_COMMAND} -E chdir ${workspace} ${colcon_program} --log-base ${workspace}/log build --base-paths src --executor sequential)
expect_words("colcon" "${output}" "Finished <<< user")
run(output ${workspace}/build/user/user)
expect_words("interfaces of colcon's" "${output}" "shoulder_pan/effort shoulder_lift/effort elbow/effort")

set(prefix ${workspace}/install/ros2_arm)
set(packages kinematics_interface inverse_dynamics_solver moveit_core)
foreach(interface kinematics_interface inverse_dynamics_solver moveit)
  list(POP_FRONT packages package)
  file(READ ${prefix}/share/ament_index/resource_index/${package}__pluginlib__plugin/ros2_arm description)
  expect_equal("the index of ${package}" "${description}" "share/ros2_arm/six_axis_${interface}.xml\n")
  file(READ ${prefix}/share/ros2_arm/six_axis_${interface}.xml description)
  expect_words("the description" "${description}" "<library path=\"six_axis_${interface}\"> <class name=\"ros2_arm/six_axis_${interface}\"")
  if(NOT EXISTS ${prefix}/lib/libsix_axis_${interface}.so)
    message(FATAL_ERROR "the plugin for ${interface} is not installed")
  endif()
endforeach()
