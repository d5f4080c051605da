# A cross build of a robot with the installed package. The generator comes from ROBCOGEN_HOST_TOOL or from the PATH,
# never from the package, whose executable is for the target machine.
#
# cmake -D CROSS_COMPILER=path -D PROCESSOR=name [-D MACHINE=name -D EMULATOR=program] -D TOOL=robcogen -D SOURCE_DIR=dir
#       -D WORK_DIR=dir -P cross.cmake
# MACHINE is the machine in the library's header. The emulator runs the library's programs, and their results are
# compared with those of the generator's interpreter on this machine.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

find_program(compiler ${CROSS_COMPILER})
if(NOT compiler)
  message("skipped: there is no ${CROSS_COMPILER}")
  return()
endif()

set(work_dir ${WORK_DIR}/cross_${PROCESSOR})
file(REMOVE_RECURSE ${work_dir})
# Setting the system name makes this a cross build.
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
if(NOT EMULATOR)
  return()
endif()
find_program(emulator ${EMULATOR})
if(NOT emulator)
  message(FATAL_ERROR "there is a compiler for ${PROCESSOR}, but no ${EMULATOR} (Debian: qemu-user)")
endif()
run(output ${CMAKE_COMMAND} --build ${work_dir}/build --target joint_forces --parallel 2)
set(q "0.1, -0.2, 0.3, 0.4, 0.5, -0.6, 0.7, 0.8, -0.9, 1.0, 1.1, 1.2")
set(qd "1, 2, -3, 4, 5, 6, -7, 8, 9, 10, 11, -12")
set(qdd "1, -2, 3, -4, 5, -6, 7, -8, 9, -10, 11, -12")
file(WRITE ${work_dir}/state.json "{\"q\": [${q}], \"qd\": [${qd}], \"qdd\": [${qdd}]}")
execute_process(
  COMMAND ${TOOL} eval ${SOURCE_DIR}/robots/quadruped_fixed/quadruped_fixed.kindsl inverse_dynamics
  INPUT_FILE ${work_dir}/state.json OUTPUT_VARIABLE tau COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[^-+.0-9e]+" " " numbers "${q} ${qd} ${qdd} ${tau}")
string(REPLACE " e " " " numbers "${numbers}")
file(WRITE ${work_dir}/numbers "${numbers}")
execute_process(COMMAND ${emulator} ${work_dir}/build/joint_forces INPUT_FILE ${work_dir}/numbers COMMAND_ERROR_IS_FATAL ANY)
