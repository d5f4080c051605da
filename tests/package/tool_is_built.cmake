# A project that adds this one without naming a tool builds the generator before it generates code. Ninja's list of
# commands shows this without another build of the generator.
#
# cmake -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir -P tool_is_built.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(build_dir ${WORK_DIR}/tool_is_built)
file(REMOVE_RECURSE ${build_dir})
run(output ${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/consumers/add_subdirectory -B ${build_dir}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBOTS_DIR=${SOURCE_DIR}/robots)
run(output ${CMAKE_COMMAND} --build ${build_dir} -- -t commands hyl)
if(NOT output MATCHES "-o robcogen/tool/robcogen .*/robcogen/tool/robcogen generate .*hyl/inverse_dynamics.cpp.o")
  message("${output}")
  message(FATAL_ERROR "the library does not wait for the generator")
endif()
