# Builds robots for Windows with MinGW, and runs their tests with wine.
#     TOOL        the generator of this machine
#     SOURCE_DIR  the project
#     FOLDER      for generated and compiled files
#     REQUIRED    a missing compiler is an error, not a skipped test
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/requirement.cmake)
skip_without("x86_64-w64-mingw32-g++-posix;wine" "g++-mingw-w64-x86-64-posix, wine, wine64")
if(skipped)
  return()
endif()

file(REMOVE_RECURSE ${FOLDER})
set(ENV{WINEPREFIX} ${FOLDER}/wine)
set(ENV{WINEDEBUG} -all)
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/robots -B ${FOLDER}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
    --toolchain ${CMAKE_CURRENT_LIST_DIR}/mingw/toolchain.cmake -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBCOGEN_HOST_TOOL=${TOOL})
run(${CMAKE_COMMAND} --build ${FOLDER}/build --parallel 2)
# The first program that wine runs makes its configuration, which takes a while.
run(wine ${FOLDER}/build/hyl_selfcheck.exe)
run(${CMAKE_CTEST_COMMAND} --test-dir ${FOLDER}/build --output-on-failure --no-tests=error)
