# Builds robots for Windows with MinGW, and runs their tests with wine.
#     TOOL        the generator of this machine
#     SOURCE_DIR  the project
#     FOLDER      for generated and compiled files
#     REQUIRED    a missing compiler is an error, not a skipped test
cmake_minimum_required(VERSION 3.22...3.25)
set(missing "")
foreach(program x86_64-w64-mingw32-g++-posix wine)
  find_program(found_${program} ${program})
  if(NOT found_${program})
    string(APPEND missing " ${program}")
  endif()
endforeach()
if(missing)
  set(advice "there is no${missing} (Debian: g++-mingw-w64-x86-64-posix, wine, wine64)")
endif()
if(advice AND REQUIRED)
  message(FATAL_ERROR "${advice}")
elseif(advice)
  message(NOTICE "skipped: ${advice}")
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
