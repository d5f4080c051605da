# A folder of tool/ includes headers of its own and of the folders that its library links, and no others. The linker
# alone would not notice: every object ends in one executable.
#
# cmake -D ARROWS=list -D SOURCE_DIR=dir -P arrows.cmake
# ARROWS: a word for each library: its name and those of the libraries that it links, with commas between.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(prefix robcogen_)
set(violations "")
# A library stands after those that it links, so that what they may include is known.
separate_arguments(ARROWS)
foreach(arrow IN LISTS ARROWS)
  string(REPLACE "," ";" libraries "${arrow}")
  list(FILTER libraries INCLUDE REGEX "^${prefix}")
  list(TRANSFORM libraries REPLACE "^${prefix}" "")
  list(POP_FRONT libraries folder)
  set(allowed_${folder} ${folder})
  foreach(library IN LISTS libraries)
    list(APPEND allowed_${folder} ${allowed_${library}})
  endforeach()

  file(GLOB_RECURSE files ${SOURCE_DIR}/tool/${folder}/*.h ${SOURCE_DIR}/tool/${folder}/*.cpp)
  foreach(file IN LISTS files)
    file(STRINGS ${file} includes REGEX "^#include \"")
    foreach(include IN LISTS includes)
      if(NOT include MATCHES "\"([a-z]+)/" OR NOT CMAKE_MATCH_1 IN_LIST allowed_${folder})
        list(APPEND violations "${file}: ${include}")
      endif()
    endforeach()
  endforeach()
endforeach()
list(JOIN violations "\n" violations)
expect_equal("includes against the arrows" "${violations}" "")
