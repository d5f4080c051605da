# Wrong calls and their messages. Each file of calls/ begins with the expected message in comment lines, in which @DIR@
# is the folder of the call; the configuration must fail with exactly that message.
#
# cmake -D TOOL=robcogen -D SOURCE_DIR=dir -D WORK_DIR=dir -P calls.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

# Sets `result` to the text of the comment lines at the beginning of the file.
function(expected_message file result)
  file(STRINGS ${file} lines)
  set(message "")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "^#( .*)$")
      break()
    endif()
    string(APPEND message "${CMAKE_MATCH_1}")
  endforeach()
  set(${result} "${message}" PARENT_SCOPE)
endfunction()

file(GLOB calls ${CMAKE_CURRENT_LIST_DIR}/calls/*.cmake)
foreach(call IN LISTS calls)
  cmake_path(GET call STEM name)
  set(directory ${WORK_DIR}/${name})
  file(REMOVE_RECURSE ${directory})
  # The project has no language, because no call reaches a compiler.
  file(WRITE ${directory}/CMakeLists.txt "
    cmake_minimum_required(VERSION 3.22...3.25)
    project(calls VERSION 1.0.0 LANGUAGES NONE)
    set(robcogen_VERSION ${VERSION})
    include(${SOURCE_DIR}/cmake/Robcogen.cmake)
    include(${call})")
  file(WRITE ${directory}/hyl.kindsl "")
  run_failing(output ${CMAKE_COMMAND} -S ${directory} -B ${directory}/build -DROBCOGEN_HOST_TOOL=${TOOL})
  expected_message(${call} expected)
  string(REPLACE "@DIR@" "${directory}" expected "${expected}")
  expect_words(${name} "${output}" "${expected}")
  string(REGEX MATCHALL "CMake Error" errors "${output}")
  expect_equal("${name}: errors" "${errors}" "CMake Error")
endforeach()
