# Builds the generator for Windows with MinGW, with static libraries only, and runs it with wine: its code and documents are
# those of the generator of this machine, byte by byte. (Of a robot whose frames are searched, constants may differ in the last
# digit, because sines and arc tangents are those of the C library.)
#     TOOL             the generator of this machine
#     SOURCE_DIR       the project
#     LIBRARY_SOURCES  the sources of the libraries that it links (cmake/bootstrap.sh sources FOLDER)
#     FOLDER           for what is made
#     REQUIRED         a missing compiler is an error, not a skipped test
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../everything/requirement.cmake)
skip_without("x86_64-w64-mingw32-g++-posix;x86_64-w64-mingw32-objdump;wine" "g++-mingw-w64-x86-64-posix, wine, wine64")
if(skipped)
  return()
elseif(NOT EXISTS ${LIBRARY_SOURCES})
  message(NOTICE "skipped: there are no sources of libraries in ${LIBRARY_SOURCES} (cmake/bootstrap.sh sources FOLDER)")
  return()
endif()
set(ENV{WINEPREFIX} ${FOLDER}/wine)
set(ENV{WINEDEBUG} -all)
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${FOLDER} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The test checks what the generator does, not how fast it is.
file(MAKE_DIRECTORY ${FOLDER})
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B build -G Ninja --toolchain ${SOURCE_DIR}/tests/everything/mingw/toolchain.cmake
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DROBCOGEN_BUILD_TARGET_TOOL=ON -DROBCOGEN_STATIC=ON
    -DROBCOGEN_LIBRARY_SOURCES=${LIBRARY_SOURCES} -DROBCOGEN_INSTALL=OFF -DROBCOGEN_EXAMPLES=OFF -DBUILD_TESTING=OFF
    -DROBCOGEN_UNITY_BUILD=ON -DROBCOGEN_PRECOMPILE_HEADERS=ON)
run(${CMAKE_COMMAND} --build build --target robcogen --parallel 2)
set(program build/tool/robcogen.exe)

execute_process(COMMAND x86_64-w64-mingw32-objdump -p ${program} WORKING_DIRECTORY ${FOLDER} OUTPUT_VARIABLE headers
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "DLL Name: [^\n]+" libraries "${headers}")
list(TRANSFORM libraries TOLOWER)
list(REMOVE_ITEM libraries "dll name: kernel32.dll" "dll name: msvcrt.dll")
if(libraries)
  message(FATAL_ERROR "the generator needs libraries that Windows does not have everywhere: ${libraries}")
endif()

# Both generators do the same in folders of their own.
foreach(maker windows here)
  file(REMOVE_RECURSE ${FOLDER}/${maker})
  file(COPY ${SOURCE_DIR}/robots/hyl/hyl.kindsl ${SOURCE_DIR}/robots/ros2_arm/six_axis.urdf
            ${SOURCE_DIR}/tests/oracles/mjcf_loops/four_bar.xml DESTINATION ${FOLDER}/${maker})
  set(tool ${TOOL})
  if(maker STREQUAL "windows")
    set(tool wine ${FOLDER}/${program})
  endif()
  foreach(
    command
    "check;hyl.kindsl"
    "check;--kinematics;six_axis.urdf"
    "generate;hyl.kindsl;-o;code;--name;hyl"
    "generate;six_axis.urdf;-o;code;--name;six_axis;--algorithms;inverse_dynamics;transforms"
    "generate;four_bar.xml;-o;../${maker}_searched;--name;four_bar;--algorithms;forward_dynamics"
    "convert;six_axis.urdf;six_axis.kindsl"
    "convert;hyl.kindsl;hyl.urdf"
    "convert;four_bar.xml;four_bar.kindsl")
    execute_process(COMMAND ${tool} ${command} WORKING_DIRECTORY ${FOLDER}/${maker} COMMAND_ECHO STDOUT
                    OUTPUT_VARIABLE output ERROR_VARIABLE messages COMMAND_ERROR_IS_FATAL ANY)
    file(APPEND ${FOLDER}/${maker}/output.txt "${output}\n${messages}")
  endforeach()
endforeach()
run(diff --recursive windows here)

# A mistake has its place, and the exit status says so.
file(WRITE ${FOLDER}/windows/wrong.kindsl "Robot wrong {\n")
execute_process(COMMAND wine ${FOLDER}/${program} check wrong.kindsl WORKING_DIRECTORY ${FOLDER}/windows RESULT_VARIABLE status
                ERROR_VARIABLE message)
if(NOT status EQUAL 1 OR NOT message MATCHES "^wrong.kindsl:[0-9]+:[0-9]+: error: ")
  message(FATAL_ERROR "exit status ${status}, message: ${message}")
endif()
