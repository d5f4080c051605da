# Installs the project among other files and removes it: only the other files are left.
#
# cmake -D BUILD_DIR=dir -D CONFIG=name -D WORK_DIR=dir -D SOURCE_DIR=dir -P uninstall.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(prefix ${WORK_DIR}/uninstalled)
file(REMOVE_RECURSE ${prefix})
file(WRITE ${prefix}/share/man/man1/other.1 "")
file(WRITE ${prefix}/include/robcogen/mine.h "")
run(output ${CMAKE_COMMAND} --install ${BUILD_DIR} --config ${CONFIG} --prefix ${prefix})
if(NOT EXISTS ${prefix}/bin/robcogen)
  message(FATAL_ERROR "nothing is installed")
endif()
run(output ${CMAKE_COMMAND} -DMANIFEST=${BUILD_DIR}/install_manifest.txt -P ${SOURCE_DIR}/cmake/uninstall.cmake)
file(GLOB_RECURSE left LIST_DIRECTORIES true RELATIVE ${prefix} ${prefix}/*)
list(SORT left)
expect_equal("left" "${left}" "include;include/robcogen;include/robcogen/mine.h;share;share/man;share/man/man1;share/man/man1/other.1")
run_failing(output ${CMAKE_COMMAND} -DMANIFEST=${BUILD_DIR}/install_manifest.txt -P ${SOURCE_DIR}/cmake/uninstall.cmake)
expect_words("the second time" "${output}" "nothing is installed from this build")
