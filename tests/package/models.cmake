# The project consumers/models: every URDF of a folder becomes a library, and each passes its self-check.
#
# cmake -D TOOL=robcogen -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir -D MODELS_DIR=dir -P models.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

file(GLOB models ${MODELS_DIR}/*.urdf)
if(NOT models)
  message("skipped: no URDF in '${MODELS_DIR}'")
  return()
endif()
set(build_dir ${WORK_DIR}/models)
file(REMOVE_RECURSE ${build_dir})
run(output ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/models -B ${build_dir}
    -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBCOGEN_HOST_TOOL=${TOOL} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${COMPILER_LAUNCHER} -DROBCOGEN_UNITY_ROBOTS=ON -DROBCOGEN_PRECOMPILE_HEADERS=ON
    -DMODELS_DIR=${MODELS_DIR})
run(output ${CMAKE_COMMAND} --build ${build_dir} --parallel 2)
run(output ${CMAKE_CTEST_COMMAND} --test-dir ${build_dir} --no-tests=error)
# There are three tests for each robot.
list(LENGTH models count)
math(EXPR count "3 * ${count}")
expect_words("tests of robots" "${output}" "100% tests passed, 0 tests failed out of ${count}")
