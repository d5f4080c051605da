# Generated MATLAB text, run by Octave on random states and compared with values of another origin.
#     OCTAVE    the program; when it is not there, the test is skipped, or fails where REQUIRED is set
#     PACKAGES  folder of the generated package, NAME its name
#     VALUES    the program that writes the values, and its arguments
#     FOLDER    for the values
#     MUTATE    a file of the package, whose first sum becomes a difference: the comparison must fail
include(${CMAKE_CURRENT_LIST_DIR}/../../package/steps.cmake)
set(states 100)

if(NOT OCTAVE)
  if(REQUIRED)
    message(FATAL_ERROR "there is no Octave")
  endif()
  message(NOTICE "skipped: there is no Octave")
  return()
endif()

file(REMOVE_RECURSE ${FOLDER})
run(ignored ${VALUES} ${states} ${FOLDER})
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

set(octave ${OCTAVE} --no-gui --norc --no-history --path ${PACKAGES} --path ${CMAKE_CURRENT_LIST_DIR} --eval
           "compare('${FOLDER}', ${states})")
if(MUTATE)
  string(REGEX REPLACE "\\.m$" "" function ${MUTATE})
  run_failing(text ${octave})
  if(NOT text MATCHES "${NAME}\\.${function}/[0-9]+ +[^ ]+  DIFFERS")
    message(FATAL_ERROR "the change of ${MUTATE} is not what made the comparison fail:\n${text}")
  endif()
  return()
endif()
run(text ${octave})
message("${text}")

# Each function has been called, in each of its forms, at each state.
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
