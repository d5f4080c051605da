# Builds the generator and robots with another compiler, and runs the robots' tests.
#     COMPILER         of C++
#     FLAGS            for all of its calls
#     TOOL             a generator, if that compiler cannot build it
#     SOURCE_DIR       the project
#     FOLDER           for generated and compiled files
#     REQUIRED         a missing compiler is an error, not a skipped test
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/requirement.cmake)
string(REPLACE "clang++" "clang" package ${COMPILER})
skip_without(${COMPILER} ${package})
if(skipped)
  return()
endif()

file(REMOVE_RECURSE ${FOLDER})
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/robots -B ${FOLDER} -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_CXX_FLAGS_RELEASE=-O1
    -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBCOGEN_HOST_TOOL=${TOOL} -DROBCOGEN_UNITY_BUILD=ON -DROBCOGEN_PRECOMPILE_HEADERS=ON)
run(${CMAKE_COMMAND} --build ${FOLDER} --parallel 2)
run(${CMAKE_CTEST_COMMAND} --test-dir ${FOLDER} --output-on-failure --no-tests=error)
