# Files in a folder of tool/ include only headers of that folder and of the libraries that its library links. The linker
# does not check this, because one executable contains all objects.
#
# cmake -D ARROWS=list -D ROOMS=list -D SOURCE_DIR=dir -P arrows.cmake
# ARROWS: a word for each library: its name and the names of the libraries that it links, separated by commas.
# ROOMS: a word for each folder inside a library: the folder and the neighbours whose headers it includes. All folders
# may include the library's headers that are in no folder.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(prefix robcogen_)
set(violations "")

# Collects the includes in a folder of tool/ that begin with `start` but do not continue with one of `allowed`.
function(collect_violations folder start)
  set(allowed ${ARGN})
  file(GLOB_RECURSE files ${SOURCE_DIR}/tool/${folder}/*.h ${SOURCE_DIR}/tool/${folder}/*.cpp)
  if(NOT files)
    list(APPEND violations "${folder}: no files")
  endif()
  foreach(file IN LISTS files)
    file(STRINGS ${file} includes REGEX "^#include \"${start}")
    if(NOT start STREQUAL "")
      list(FILTER includes EXCLUDE REGEX "\"${start}[a-z_]+\\.h\"")
    endif()
    foreach(include IN LISTS includes)
      if(NOT include MATCHES "\"${start}([a-z]+)/" OR NOT CMAKE_MATCH_1 IN_LIST allowed)
        list(APPEND violations "${file}: ${include}")
      endif()
    endforeach()
  endforeach()
  set(violations "${violations}" PARENT_SCOPE)
endfunction()

# A library comes after the libraries that it links, so their allowed headers are known.
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
  collect_violations(${folder} "" ${allowed_${folder}})
endforeach()

# The folders inside a library are in such an order, too.
separate_arguments(ROOMS)
foreach(room IN LISTS ROOMS)
  string(REPLACE "," ";" neighbours "${room}")
  list(POP_FRONT neighbours folder)
  cmake_path(GET folder PARENT_PATH library)
  cmake_path(GET folder FILENAME name)
  set(allowed_${folder} ${name})
  foreach(neighbour IN LISTS neighbours)
    list(APPEND allowed_${folder} ${allowed_${library}/${neighbour}})
  endforeach()
  collect_violations(${folder} "${library}/" ${allowed_${folder}})
endforeach()
list(JOIN violations "\n" violations)
expect_equal("includes against the arrows" "${violations}" "")
