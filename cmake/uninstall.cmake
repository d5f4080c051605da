# Removes the files that the last `cmake --install` of a build installed, and folders that are then empty.
#
# cmake -D MANIFEST=build/install_manifest.txt -P uninstall.cmake
cmake_minimum_required(VERSION 3.22)

if(NOT EXISTS "${MANIFEST}")
  message(FATAL_ERROR "nothing is installed from this build: ${MANIFEST} does not exist")
endif()
file(STRINGS "${MANIFEST}" files)
set(folders "")
foreach(file IN LISTS files)
  file(REMOVE "$ENV{DESTDIR}${file}")
  cmake_path(GET file PARENT_PATH folder)
  list(APPEND folders "$ENV{DESTDIR}${folder}")
endforeach()
file(REMOVE "${MANIFEST}")

# Removes empty folders, and their parents if these are then empty.
list(REMOVE_DUPLICATES folders)
foreach(folder IN LISTS folders)
  file(GLOB content "${folder}/*")
  while(IS_DIRECTORY "${folder}" AND NOT content)
    file(REMOVE_RECURSE "${folder}")
    cmake_path(GET folder PARENT_PATH folder)
    file(GLOB content "${folder}/*")
  endwhile()
endforeach()
list(LENGTH files count)
message(STATUS "${count} files removed")
