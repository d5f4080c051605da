# A project that adds this one and names no tool builds the generator before it generates. A dry run shows the order;
# the build itself is the one that this test belongs to.
#
# cmake -D SOURCE_DIR=dir -D WORK_DIR=dir -P tool_is_built.cmake
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(build_dir ${WORK_DIR}/tool_is_built)
file(REMOVE_RECURSE ${build_dir})
run(output ${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/consumers/add_subdirectory -B ${build_dir}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBOTS_DIR=${SOURCE_DIR}/robots)
run(output ${CMAKE_COMMAND} --build ${build_dir} --target hyl -- -n -j1)
if(NOT output MATCHES "Linking CXX executable robcogen/tool/robcogen.*Generating robot hyl.*hyl/inverse_dynamics.cpp.o")
  message(FATAL_ERROR "the generator is not built before it runs:\n${output}")
endif()
