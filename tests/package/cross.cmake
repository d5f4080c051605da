# A cross build of a robot with the installed package: the generator comes from ROBCOGEN_HOST_TOOL or from the PATH,
# never from the package, whose executable is for the other machine.
#
# cmake -D CROSS_COMPILER=path -D PROCESSOR=name [-D MACHINE=name] -D TOOL=robcogen -D SOURCE_DIR=dir -D WORK_DIR=dir
#       -P cross.cmake
# MACHINE is the machine in the header of the library.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

find_program(compiler ${CROSS_COMPILER})
if(NOT compiler)
  message("skipped: there is no ${CROSS_COMPILER}")
  return()
endif()

set(work_dir ${WORK_DIR}/cross_${PROCESSOR})
file(REMOVE_RECURSE ${work_dir})
# Naming the system is what makes a build a cross build.
file(WRITE ${work_dir}/toolchain.cmake "
  set(CMAKE_SYSTEM_NAME Linux)
  set(CMAKE_SYSTEM_PROCESSOR ${PROCESSOR})
  set(CMAKE_CXX_COMPILER ${compiler})
  set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)")
set(configure ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/cross --toolchain ${work_dir}/toolchain.cmake
              -DCMAKE_PREFIX_PATH=${WORK_DIR}/installed -DROBOTS_DIR=${SOURCE_DIR}/robots)

cmake_path(GET TOOL PARENT_PATH tool_dir)
run(output ${CMAKE_COMMAND} -E env PATH=${tool_dir}:/usr/bin:/bin ${configure} -B ${work_dir}/tool_on_path)

run(output ${configure} -B ${work_dir}/build -DROBCOGEN_HOST_TOOL=${TOOL})
run(output ${CMAKE_COMMAND} --build ${work_dir}/build --target hyl --parallel 2)
if(MACHINE)
  run(output readelf -h ${work_dir}/build/libhyl.a)
  expect_words("header of the library" "${output}" "Machine: ${MACHINE}")
endif()
