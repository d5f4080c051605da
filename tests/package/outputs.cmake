# The list of generated files that CMake computes is the one that the generator prints.
#
# cmake -D TOOL=robcogen -D SOURCE_DIR=dir -P outputs.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
include(${SOURCE_DIR}/cmake/Robcogen.cmake)

function(expect_same_outputs name)
  set(library_ALGORITHMS ${ARGN})
  _robcogen_choose_groups()
  _robcogen_generated_files(${name} "${library_groups}" headers sources)
  set(expected ${headers} ${sources})
  set(algorithms "")
  if(ARGN)
    set(algorithms --algorithms ${library_ALGORITHMS})
  endif()
  run(actual ${TOOL} generate --list-outputs --name ${name} ${algorithms})
  string(STRIP "${actual}" actual)
  string(REPLACE "\n" ";" actual "${actual}")
  list(SORT actual)
  list(SORT expected)
  expect_equal("outputs of ${name} (${ARGN})" "${actual}" "${expected}")
endfunction()

expect_same_outputs(hyl)
expect_same_outputs(r2 jacobians)
expect_same_outputs(hyl joint_space_inertia inverse_dynamics)
get_property(groups GLOBAL PROPERTY ROBCOGEN_GROUPS)
expect_same_outputs(all_named ${groups})
expect_same_outputs(all all)
# Called like one of its own headers.
expect_same_outputs(robot)
expect_same_outputs(Jacobians)
