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

function(stop)
  message(FATAL_ERROR "${XACRO} cannot expand ${MODEL}: exit status ${status}")
endfunction()

cmake_path(GET OUTPUT PARENT_PATH directory)
file(MAKE_DIRECTORY "${directory}")
# Relative paths that xacro prints refer to this folder.
execute_process(
  COMMAND ${XACRO} --deps ${MODEL} ${arguments}
  WORKING_DIRECTORY "${directory}"
  OUTPUT_VARIABLE included
  OUTPUT_STRIP_TRAILING_WHITESPACE
  RESULT_VARIABLE status)
if(NOT status STREQUAL "0")
  stop()
endif()

# Names are separated by blanks. The parts of a name that contains blanks are joined until they name a file.
separate_arguments(words UNIX_COMMAND "${included}")
set(rule "")
set(name "")
file(REAL_PATH "${OUTPUT}" written)
foreach(word IN LISTS MODEL words)
  string(APPEND name "${word}")
  cmake_path(ABSOLUTE_PATH name BASE_DIRECTORY "${directory}" NORMALIZE OUTPUT_VARIABLE file)
  if(NOT EXISTS "${file}")
    string(APPEND name " ")
    continue()
  endif()
  file(REAL_PATH "${file}" read)
  if(read STREQUAL written)
    message(FATAL_ERROR "the output would replace the input: ${OUTPUT} is a file that xacro reads for ${MODEL}")
  endif()
  string(REPLACE "$" "$$" file "${file}")
  string(REGEX REPLACE "([ #])" "\\\\\\1" file "${file}")
  string(APPEND rule " \\\n  ${file}")
  set(name "")
endforeach()
# xacro writes to a new file, which then replaces the earlier one: a link to a source must not be followed.
execute_process(
  COMMAND ${XACRO} ${MODEL} ${arguments} -o ${OUTPUT}.new
  WORKING_DIRECTORY "${directory}"
  RESULT_VARIABLE status)
if(NOT status STREQUAL "0")
  file(REMOVE "${OUTPUT}.new" "${OUTPUT}")
  stop()
endif()
file(RENAME "${OUTPUT}.new" "${OUTPUT}")
string(REPLACE "$" "$$" target "${OUTPUT}")
string(REGEX REPLACE "([ #])" "\\\\\\1" target "${target}")
file(WRITE "${OUTPUT}.d" "${target}:${rule}\n")
