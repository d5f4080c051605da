# The quick start of README.md, line by line except the first, because its packages are already installed.
#
# cmake -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir -P quick_start.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

find_program(bash bash)
if(NOT bash)
  message("skipped: there is no bash")
  return()
endif()

file(READ ${SOURCE_DIR}/README.md readme)
if(NOT readme MATCHES "\n## Quick start\n[^`]*`[^`]*`[^`]*`[^`]*`[^`]*```sh\n([^\n]*bootstrap.sh install ~/robcogen[^\n]*\n)")
  message(FATAL_ERROR "README.md has no quick start that begins with bootstrap.sh install ~/robcogen")
endif()
set(first "${CMAKE_MATCH_1}")
string(FIND "${readme}" "${first}" begin)
string(LENGTH "${first}" length)
math(EXPR begin "${begin} + ${length}")
string(SUBSTRING "${readme}" ${begin} -1 lines)
string(FIND "${lines}" "```" end)
string(SUBSTRING "${lines}" 0 ${end} lines)

set(work_dir ${WORK_DIR}/quick_start)
file(REMOVE_RECURSE ${work_dir})
file(MAKE_DIRECTORY ${work_dir}/home ${work_dir}/user)
file(CREATE_LINK ${WORK_DIR}/installed ${work_dir}/home/robcogen SYMBOLIC)
file(COPY ${CMAKE_CURRENT_LIST_DIR}/consumers/urdf/arm.urdf DESTINATION ${work_dir}/user)
file(WRITE ${work_dir}/lines.sh "${lines}")
run(output ${CMAKE_COMMAND} -E chdir ${work_dir}/user ${CMAKE_COMMAND} -E env HOME=${work_dir}/home CXX=${CXX_COMPILER} ${bash} -e
    ${work_dir}/lines.sh)
if(NOT output MATCHES "joint forces that hold the arm: +-?[0-9]")
  message(FATAL_ERROR "the program of the quick start printed no joint forces:\n${output}")
endif()
