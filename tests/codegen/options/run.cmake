# Compiles a user's part with options of its own, links it with the library, and runs it.
#
# cmake -D COMPILER=path -D INCLUDES=dir,dir -D EIGEN=dir -D WORK=prefix -D LIBRARY=prefix [-D OUTCOME=runs|refused|apart -D "OPTIONS=option option"]
#       -P run.cmake
#
# refused: the compiler stops with a message. apart: two files of a program, one of them compiled with these options, do not
# link if they pass each other results. Without OUTCOME it compiles the library, and the expected numbers, with the compiler's default options.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../flags/steps.cmake)

list_includes(includes)
list(APPEND includes -isystem ${EIGEN})
if(NOT OUTCOME)
  # All units at once, and without warnings: other tests see to those.
  list(GET includes 0 folder)
  string(REGEX REPLACE "^-I" "" folder "${folder}")
  file(GLOB units ${folder}/walker/*.cpp)
  list(TRANSFORM units REPLACE "(.+)" "#include \"\\1\"")
  list(JOIN units "\n" text)
  file(WRITE ${LIBRARY}.cpp "${text}\n")
  run(output ${COMPILER} -std=c++17 ${includes} -c ${LIBRARY}.cpp -o ${LIBRARY}.o)
  run(output ${COMPILER} -std=c++17 ${includes} -c ${CMAKE_CURRENT_LIST_DIR}/expected.cpp -o ${LIBRARY}_expected.o)
  return()
endif()

set(user ${CMAKE_CURRENT_LIST_DIR}/user.cpp)
separate_arguments(options UNIX_COMMAND "${OPTIONS}")
if(OUTCOME STREQUAL "refused")
  execute_process(
    COMMAND ${COMPILER} -std=c++17 -Wfatal-errors ${options} ${includes} -fsyntax-only ${user} OUTPUT_VARIABLE text ERROR_VARIABLE text
    RESULT_VARIABLE status)
  if(status EQUAL 0 OR NOT text MATCHES "compile this file without -fpack-struct")
    message(FATAL_ERROR "${OPTIONS} is not refused with the message: ${text}")
  endif()
  return()
endif()
if(OUTCOME STREQUAL "apart")
  set(file ${CMAKE_CURRENT_LIST_DIR}/layouts.cpp)
  run(output ${COMPILER} -std=c++17 ${includes} -DCALLS -c ${file} -o ${WORK}_caller.o)
  run(output ${COMPILER} -std=c++17 ${includes} -c ${file} -o ${WORK}_same.o)
  run(output ${COMPILER} -std=c++17 ${includes} ${options} -c ${file} -o ${WORK}_other.o)
  run(output ${COMPILER} ${WORK}_caller.o ${WORK}_same.o -o ${WORK})
  execute_process(
    COMMAND ${COMPILER} ${WORK}_caller.o ${WORK}_other.o -o ${WORK} OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE status)
  if(status EQUAL 0 OR NOT text MATCHES "undefined reference to [^\n]*step")
    message(FATAL_ERROR "files with different layouts of results link: ${text}")
  endif()
  return()
endif()
run(output ${COMPILER} -std=c++17 ${warnings} ${options} ${includes} -c ${user} -o ${WORK}.o)
run(output ${COMPILER} ${options} ${WORK}.o ${LIBRARY}.o ${LIBRARY}_expected.o -o ${WORK})
execute_process(COMMAND ${WORK} OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE status)
if(status EQUAL 77)
  message("skipped: the processor has no instructions for ${OPTIONS}")
elseif(NOT status EQUAL 0)
  message(FATAL_ERROR "${text}\nexit status ${status} with ${OPTIONS}")
endif()
