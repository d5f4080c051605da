# Robots with one NAME in different NAMESPACEs, and how their sources are compiled in a build without a type.
#
# cmake -D TOOL=robcogen -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir -P namespaces.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(build_dir ${WORK_DIR}/namespaces)
set(configure
    ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/namespaces -B ${build_dir} -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR}
    -DROBCOGEN_HOST_TOOL=${TOOL} -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DROBOTS_DIR=${SOURCE_DIR}/robots
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)

# The last -O flag in a source's compile command counts; `expected` is "" if there is none.
function(expect_optimisation event source expected)
  file(STRINGS ${build_dir}/compile_commands.json commands REGEX "\"command\":.*${source}\"")
  list(LENGTH commands count)
  expect_equal("${event}: commands that compile ${source}" "${count}" 1)
  string(REGEX MATCHALL " -O[a-z0-9]*" found "${commands}")
  list(TRANSFORM found STRIP)
  set(last "")
  if(found)
    list(GET found -1 last)
  endif()
  expect_equal("${event}: optimisation of ${source}" "${last}" "${expected}")
endfunction()

file(REMOVE_RECURSE ${build_dir})
run(output ${configure})
expect_optimisation("no build type" left/leg/inverse_dynamics.cpp -O2)
expect_optimisation("no build type" slow/leg/inverse_dynamics.cpp -O0)
expect_optimisation("no build type" namespaces/main.cpp "")
run(output ${CMAKE_COMMAND} --build ${build_dir} --parallel 2)
run(output ${build_dir}/legs)

# Optimised code is much shorter.
foreach(side left slow)
  file(GLOB_RECURSE object ${build_dir}/CMakeFiles/${side}_leg.dir/*inverse_dynamics.cpp.o)
  file(SIZE ${object} ${side}_size)
endforeach()
math(EXPR bound "${left_size} * 3 / 2")
if(slow_size LESS bound)
  message(FATAL_ERROR "an object without optimisation takes ${slow_size} bytes, and one with it ${left_size}")
endif()

# Optimisation flags and others that the user sets stay unchanged.
foreach(case "Debug;-g;-O2" "Debug;-g -Og;-O2" "Debug;-O1 -fsanitize=undefined;-O1" "Release;-O3;-O3" "MinSizeRel;-Os;-Os")
  list(GET case 0 type)
  list(GET case 1 flags)
  list(GET case 2 expected)
  string(TOUPPER ${type} upper)
  run(output ${configure} -DCMAKE_BUILD_TYPE=${type} "-DCMAKE_CXX_FLAGS_${upper}=${flags}")
  expect_optimisation("${type} with ${flags}" left/leg/inverse_dynamics.cpp ${expected})
  expect_optimisation("${type} with ${flags}" slow/leg/inverse_dynamics.cpp -O0)
  file(STRINGS ${build_dir}/compile_commands.json commands REGEX "left/leg/inverse_dynamics.cpp\"")
  expect_words("${type}" "${commands}" " ${flags} ")
endforeach()
