# Installs the project and moves the installed tree, which must not remember its original place.
#
# cmake -D BUILD_DIR=dir -D CONFIG=name -D WORK_DIR=dir -P install.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

file(REMOVE_RECURSE ${WORK_DIR}/staged ${WORK_DIR}/installed)
run(output ${CMAKE_COMMAND} --install ${BUILD_DIR} --config ${CONFIG} --prefix ${WORK_DIR}/staged)
file(RENAME ${WORK_DIR}/staged ${WORK_DIR}/installed)

# Python finds the package by a path from the folder of its packages.
file(GLOB path ${WORK_DIR}/installed/lib/python*/site-packages/robcogen.pth)
if(path AND EXISTS /usr/bin/python3)
  cmake_path(GET path PARENT_PATH folder)
  run(output /usr/bin/python3 -B -c "__import__('site').addsitedir('${folder}') or print(__import__('robcogen').__file__, end='')")
  expect_equal("the Python package" "${output}" "${WORK_DIR}/installed/share/robcogen/python/robcogen/__init__.py")
endif()
