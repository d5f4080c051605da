# Expands a file with xacro, and writes the files that it includes to a dependency file.
#
# cmake -D XACRO=program -D MODEL=arm.urdf.xacro -D OUTPUT=arm.urdf -P RobcogenExpandXacro.cmake -- name:=value…
cmake_minimum_required(VERSION 3.22...3.25)

set(arguments "")
set(are_arguments FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(are_arguments)
    list(APPEND arguments "${CMAKE_ARGV${i}}")
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(are_arguments TRUE)
  endif()
endforeach()

cmake_path(GET OUTPUT PARENT_PATH directory)
file(MAKE_DIRECTORY "${directory}")
# Relative paths that xacro prints refer to this folder.
execute_process(
  COMMAND ${XACRO} --deps ${MODEL} ${arguments}
  WORKING_DIRECTORY "${directory}"
  OUTPUT_VARIABLE included
  OUTPUT_STRIP_TRAILING_WHITESPACE
  RESULT_VARIABLE status)
if(status STREQUAL "0")
  execute_process(
    COMMAND ${XACRO} ${MODEL} ${arguments} -o ${OUTPUT}
    WORKING_DIRECTORY "${directory}"
    RESULT_VARIABLE status)
endif()
if(NOT status STREQUAL "0")
  file(REMOVE "${OUTPUT}")
  message(FATAL_ERROR "${XACRO} cannot expand ${MODEL}: exit status ${status}")
endif()

# Names are separated by blanks. The parts of a name that contains blanks are joined until they name a file.
separate_arguments(words UNIX_COMMAND "${included}")
set(rule "")
set(name "")
foreach(word IN LISTS MODEL words)
  string(APPEND name "${word}")
  cmake_path(ABSOLUTE_PATH name BASE_DIRECTORY "${directory}" NORMALIZE OUTPUT_VARIABLE file)
  if(NOT EXISTS "${file}")
    string(APPEND name " ")
    continue()
  endif()
  string(REPLACE "$" "$$" file "${file}")
  string(REGEX REPLACE "([ #])" "\\\\\\1" file "${file}")
  string(APPEND rule " \\\n  ${file}")
  set(name "")
endforeach()
string(REPLACE "$" "$$" target "${OUTPUT}")
string(REGEX REPLACE "([ #])" "\\\\\\1" target "${target}")
file(WRITE "${OUTPUT}.d" "${target}:${rule}\n")
