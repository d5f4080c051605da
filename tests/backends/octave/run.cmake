# Generated MATLAB text, run by Octave on random states and compared with values of another origin.
#     OCTAVE    the program; when it is not there, the test is skipped, or fails where REQUIRED is set
#     PACKAGES  folder of the generated package, NAME its name
#     VALUES    the program that writes the values, and its arguments
#     FOLDER    for the values
#     MUTATE    a file of the package and the text in it that gets another sign: the comparison must fail
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
  list(GET MUTATE 0 file)
  list(GET MUTATE 1 text)
  list(GET MUTATE 2 replacement)
  file(READ ${PACKAGES}/+${NAME}/${file} original)
  string(REPLACE "${text}" "${replacement}" changed "${original}")
  if(changed STREQUAL original)
    message(FATAL_ERROR "${file} has no '${text}'")
  endif()
  file(WRITE ${PACKAGES}/+${NAME}/${file} "${changed}")
endif()

set(octave ${OCTAVE} --no-gui --norc --no-history --path ${PACKAGES} --path ${CMAKE_CURRENT_LIST_DIR} --eval
           "compare('${FOLDER}', ${states})")
if(MUTATE)
  string(REGEX REPLACE "\\.m$" "" function ${file})
  run_failing(text ${octave})
  if(NOT text MATCHES "${NAME}\\.${function}/[0-9]+ +[^ ]+  DIFFERS")
    message(FATAL_ERROR "the change of ${file} is not what made the comparison fail:\n${text}")
  endif()
  return()
endif()
run(text ${octave})
message("${text}")

# Each function has been called, in each of its forms, at each state.
file(GLOB_RECURSE files RELATIVE ${PACKAGES} ${PACKAGES}/+${NAME}/*.m)
list(FILTER files EXCLUDE REGEX "^[^/]+/(model|parameters)\\.m$")
list(LENGTH files functions)
file(STRINGS ${FOLDER}/calls.txt lines)
list(LENGTH lines calls)
math(EXPR compared "${calls} * ${states}")
if(functions EQUAL 0)
  message(FATAL_ERROR "there is nothing to compare")
endif()
expect_words(report "${text}" "${functions} functions, ${calls} calls, ${compared} states compared, 0 differ")
