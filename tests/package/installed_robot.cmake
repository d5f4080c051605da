# Checks of a user of the installed package: the robot's self-check passes, each of its headers compiles alone, and the
# robot itself can be installed.
#
# cmake -D BUILD_DIR=dir -D WORK_DIR=dir -P installed_robot.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

run(output ${CMAKE_CTEST_COMMAND} --test-dir ${BUILD_DIR} --output-on-failure --no-tests=error --label-regex
    "robot|transforms")
expect_words("self-checks" "${output}" "hyl.selfcheck")
expect_words("self-checks" "${output}" "euler.selfcheck")
run(output ${CMAKE_COMMAND} --build ${BUILD_DIR} --target all_verify_interface_header_sets --parallel 2)
run(output ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/robots)
foreach(file hyl.h kernel/inverse_dynamics.h)
  if(NOT EXISTS ${WORK_DIR}/robots/include/hyl/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
