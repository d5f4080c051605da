# Functions for the scripts in this folder.
cmake_minimum_required(VERSION 3.22...3.25)

# Runs a command and sets `output` to its output. If the command fails, stops the script and prints the output.
function(run output)
  execute_process(
    COMMAND ${ARGN}
    OUTPUT_VARIABLE text
    ERROR_VARIABLE text
    RESULT_VARIABLE status)
  if(NOT status STREQUAL "0")
    list(JOIN ARGN " " command)
    message("${text}")
    message(FATAL_ERROR "exit status ${status} of ${command}")
  endif()
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

# Runs a command that is expected to fail.
function(run_failing output)
  execute_process(
    COMMAND ${ARGN}
    OUTPUT_VARIABLE text
    ERROR_VARIABLE text
    RESULT_VARIABLE status)
  if(status STREQUAL "0")
    list(JOIN ARGN " " command)
    message("${text}")
    message(FATAL_ERROR "must fail and does not: ${command}")
  endif()
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

function(expect_equal what actual expected)
  if(NOT actual STREQUAL expected)
    message(FATAL_ERROR "${what}: is\n  ${actual}\nmust be\n  ${expected}")
  endif()
endfunction()

# Compares messages as sequences of words, because CMake wraps lines.
function(expect_words what text expected)
  string(REGEX REPLACE "[ \n]+" " " text "${text}")
  string(REGEX REPLACE "[ \n]+" " " expected "${expected}")
  string(STRIP "${expected}" expected)
  string(FIND "${text}" "${expected}" position)
  if(position EQUAL -1)
    message("${text}")
    message(FATAL_ERROR "${what}: must contain\n  ${expected}")
  endif()
endfunction()
