# Checks each header of the runtime by itself: under C++17 it compiles, or the only error is a line that names the
# required standard. Variables: COMPILER, EIGEN (include directory), HEADERS (include directory), WORK_DIR.
set(warnings -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wundef -Werror)

# Sets `messages` to the messages of compiling these headers under this standard.
function(compile standard messages)
  set(text "")
  foreach(header IN LISTS ARGN)
    string(APPEND text "#include <${header}>\n")
  endforeach()
  cmake_path(GET COMPILER FILENAME compiler)  # tests of several compilers run at once
  file(WRITE ${WORK_DIR}/standards.${compiler}.cpp "${text}")
  execute_process(
    COMMAND ${COMPILER} -std=c++${standard} -fsyntax-only ${warnings} -isystem ${EIGEN} -I${HEADERS} ${WORK_DIR}/standards.${compiler}.cpp
    ERROR_VARIABLE text)
  set(${messages} "${text}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE headers RELATIVE ${HEADERS} ${HEADERS}/robcogen/*.h)
list(FILTER headers EXCLUDE REGEX "/python/")  # these need the headers of Python
list(FILTER headers EXCLUDE REGEX "/ros/")  # most of these need ROS
list(FILTER headers EXCLUDE REGEX "/vamp\\.h$")  # this needs the headers of VAMP
list(FILTER headers EXCLUDE REGEX "/compatibility/")  # these need the headers of the first RobCoGen
list(FILTER headers EXCLUDE REGEX "/gpu/(arrays|scalar)\\.h$")  # parts of gpu/dialect.h
set(older "")
set(newer "")
foreach(header IN LISTS headers)
  file(STRINGS ${HEADERS}/${header} needs REGEX "Needs C\\+\\+20|needs C\\+\\+20")
  if(needs)
    list(APPEND newer ${header})
  else()
    list(APPEND older ${header})
  endif()
endforeach()
list(LENGTH newer count)
if(count LESS 6)
  message(FATAL_ERROR "headers that need C++20: ${newer}")
endif()

foreach(header IN LISTS newer)
  compile(17 messages ${header})
  string(REGEX MATCHALL "error: [^\n]*" errors "${messages}")
  if(NOT errors MATCHES "^error: (#error )?\"${header} needs C\\+\\+20: compile with -std=c\\+\\+20\"$")
    message(FATAL_ERROR "${header} under C++17:\n${messages}")
  endif()
endforeach()
compile(17 messages ${older})
if(messages)
  message(FATAL_ERROR "under C++17:\n${messages}")
endif()
compile(20 messages ${headers})
if(messages)
  message(FATAL_ERROR "under C++20:\n${messages}")
endif()
