# Runs generated MATLAB text in Octave on random states and compares the results with independent values.
#     OCTAVE    the program; if it is missing, the test is skipped, or fails if REQUIRED is set
#     PACKAGES  folder of the generated package, NAME its name
#     VALUES    the program that writes the values of MODEL with DESIRED (or none), with products of PRIMITIVES (right, left or none)
#     FOLDER    folder of the values
#     DERIVATIVES   the derivatives that the package was generated with
#     STATES    number of states, 20 unless given
#     MUTATE    a file of the package whose first sum is changed to a difference: the comparison must fail
include(${CMAKE_CURRENT_LIST_DIR}/../../package/steps.cmake)
set(states 20)
if(STATES)
  set(states ${STATES})
endif()

if(NOT OCTAVE)
  if(REQUIRED)
    message(FATAL_ERROR "there is no Octave")
  endif()
  message(NOTICE "skipped: there is no Octave")
  return()
endif()

file(REMOVE_RECURSE ${FOLDER})
run(ignored ${VALUES} ${MODEL} ${DESIRED} ${NAME} ${PRIMITIVES} ${states} ${FOLDER} ${DERIVATIVES})
if(MUTATE)
  file(COPY ${PACKAGES}/+${NAME} DESTINATION ${FOLDER})
  set(PACKAGES ${FOLDER})
  file(READ ${PACKAGES}/+${NAME}/${MUTATE} text)
  if(NOT text MATCHES "\n  [A-Za-z0-9_]+ = [^\n+]* \\+ [^\n]*")
    message(FATAL_ERROR "${MUTATE} has no sum")
  endif()
  set(line "${CMAKE_MATCH_0}")
  string(REPLACE " + " " - " changed "${line}")
  string(REPLACE "${line}" "${changed}" text "${text}")
  file(WRITE ${PACKAGES}/+${NAME}/${MUTATE} "${text}")
endif()

set(octave ${OCTAVE} --no-gui --norc --no-history --path ${PACKAGES} --path ${CMAKE_CURRENT_LIST_DIR})
set(primitives "")
if(NOT PRIMITIVES STREQUAL "none")
  # Statements of --eval are separated by commas, because a semicolon would begin another element of this list.
  set(primitives "primitives_${PRIMITIVES}, ")
endif()
list(APPEND octave --eval "${primitives}compare('${FOLDER}', ${states})")
if(MUTATE)
  string(REGEX REPLACE "\\.m$" "" function ${MUTATE})
  string(REGEX REPLACE "\\+([a-z]+)/" "\\1." function ${function})
  run_failing(text ${octave})
  if(NOT text MATCHES "${NAME}\\.${function}/[0-9]+ +[^ ]+  DIFFERS")
    message(FATAL_ERROR "the change of ${MUTATE} is not what made the comparison fail:\n${text}")
  endif()
  return()
endif()
run(text ${octave})
message("${text}")

# Each function has been called in each of its forms at each state.
file(GLOB_RECURSE files RELATIVE ${PACKAGES} ${PACKAGES}/+${NAME}/*.m)
list(FILTER files EXCLUDE REGEX "^[^/]+/(Contents|model|parameters)\\.m$")
list(LENGTH files functions)
file(STRINGS ${FOLDER}/calls.txt lines)
list(LENGTH lines calls)
math(EXPR compared "${calls} * ${states}")
if(functions EQUAL 0)
  message(FATAL_ERROR "there is nothing to compare")
endif()
expect_words(report "${text}" "${functions} functions, ${calls} calls, ${compared} states compared, 0 differ")
