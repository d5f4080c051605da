# Installs the project and moves the installed tree, which must not remember its original place.
#
# cmake -D BUILD_DIR=dir -D CONFIG=name -D WORK_DIR=dir -P install.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

file(REMOVE_RECURSE ${WORK_DIR}/staged ${WORK_DIR}/installed)
run(output ${CMAKE_COMMAND} --install ${BUILD_DIR} --config ${CONFIG} --prefix ${WORK_DIR}/staged)
file(RENAME ${WORK_DIR}/staged ${WORK_DIR}/installed)
