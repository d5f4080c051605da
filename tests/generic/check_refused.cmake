# Compiles a file whose lines `// expected: text` each announce one error, and compares the errors with them: no call
# causes pages of messages. Variables: COMPILER, EIGEN, HEADERS (a list of include directories), FILE.
file(STRINGS ${FILE} expected REGEX "^// expected: ")
list(LENGTH expected count)
list(TRANSFORM HEADERS PREPEND -I)
execute_process(
  COMMAND ${COMPILER} -std=c++20 -fsyntax-only -isystem ${EIGEN} ${HEADERS} ${FILE}
  RESULT_VARIABLE status
  ERROR_VARIABLE messages)
string(REPLACE ";" "," messages "${messages}")  # a list has them between its elements
string(REGEX MATCHALL "error: [^\n]*" errors "${messages}")
list(LENGTH errors found)
if(status EQUAL 0 OR NOT found EQUAL count)
  message(FATAL_ERROR "${found} errors instead of ${count}:\n${messages}")
endif()
foreach(line IN LISTS expected)
  string(REPLACE "// expected: " "" text "${line}")
  string(FIND "${errors}" "${text}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "no error says \"${text}\":\n${messages}")
  endif()
endforeach()
