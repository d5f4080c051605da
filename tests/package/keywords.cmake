# The project consumers/keywords, and the effects of its keywords.
#
# cmake -D TOOL=robcogen -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir -P keywords.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(build_dir ${WORK_DIR}/keywords)
file(REMOVE_RECURSE ${build_dir})
run(output ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/keywords -B ${build_dir}
    -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBCOGEN_HOST_TOOL=${TOOL} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
    -DROBOTS_DIR=${SOURCE_DIR}/robots -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
expect_words("properties" "${output}" "ROBCOGEN_MODEL ${build_dir}/leg.kindsl")
expect_words("properties" "${output}" "ROBCOGEN_NAME right_leg")

# Code generation alone writes every announced file, and no others.
run(output ${CMAKE_COMMAND} --build ${build_dir} --target left-leg_codegen)
file(STRINGS ${build_dir}/left_files announced)
file(GLOB_RECURSE made ${build_dir}/left/walker/legs/left_leg/*)
list(SORT announced)
list(SORT made)
expect_equal("files of left-leg" "${made}" "${announced}")

run(output ${CMAKE_COMMAND} --build ${build_dir} --parallel 2)
run(output ${build_dir}/user/controller)
run(output ${CMAKE_CTEST_COMMAND} --test-dir ${build_dir} --no-tests=error)
foreach(test selfcheck allocations real_time)
  expect_words("tests" "${output}" "left-leg.${test}")
endforeach()
expect_words("tests" "${output}" "100% tests passed, 0 tests failed out of 3")

foreach(file model inverse_dynamics +transforms/+homogeneous/fr_base_X_fr_foot)
  if(NOT EXISTS ${build_dir}/script/matlab/+script/${file}.m)
    message(FATAL_ERROR "LANGUAGES matlab made no ${file}.m")
  endif()
endforeach()
if(NOT EXISTS ${build_dir}/script/maxima/script.mac)
  message(FATAL_ERROR "LANGUAGES maxima made no script.mac")
endif()
if(EXISTS ${build_dir}/script/script)
  message(FATAL_ERROR "LANGUAGES matlab maxima made C++")
endif()

# Flags of generated sources, those of the function and of COMPILE_OPTIONS, apply to these only.
file(STRINGS ${build_dir}/compile_commands.json commands REGEX "\"command\":")
set(flags "-fno-tree-slp-vectorize|-fno-(tree-)?dse|-fno-schedule-insns2|-fno-exceptions|-fstack-usage|-DNDEBUG|-mavx")
foreach(source "left_leg/transforms.cpp" "user/main.cpp")
  set(command "${commands}")
  list(FILTER command INCLUDE REGEX "${source}\"")
  if(NOT command)
    message(FATAL_ERROR "nothing compiles ${source}")
  endif()
  set(found "")
  if(command MATCHES " (${flags})")
    set(found "${CMAKE_MATCH_1}")
  endif()
  if(source STREQUAL "user/main.cpp" AND found)
    message(FATAL_ERROR "${source} is compiled with ${found}: ${command}")
  elseif(source MATCHES "left_leg" AND NOT found)
    message(FATAL_ERROR "${source} is compiled without flags of its own: ${command}")
  endif()
endforeach()

run_failing(output ${CMAKE_COMMAND} --build ${build_dir} --target wrong)
expect_words("robot outside of all" "${output}" "/wrong.kindsl:1:")
