# Writes the tests of a GoogleTest program, one for each suite, to a file that ctest includes. Starting a process for
# each case would take longer than most cases do.
#
# cmake -D PROGRAM=path -D PREFIX=text -D DIRECTORY=dir -D OUTPUT=file -P discover_suites.cmake
cmake_minimum_required(VERSION 3.22...3.25)

execute_process(
  COMMAND ${PROGRAM} --gtest_list_tests
  WORKING_DIRECTORY ${DIRECTORY}
  TIMEOUT 120
  OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
# A suite is a line `Suite.`, followed by `  # TypeParam = …` if it is typed; its cases are indented.
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${listed}")
list(TRANSFORM suites REPLACE "\n|\\.$" "")
if(NOT suites)
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()

# The last lines that GoogleTest prints if all cases were skipped and none failed.
set(skipped [=[\\[  PASSED  \\] 0 tests\\.\n\\[  SKIPPED \\] [0-9]+ tests?, listed below:\n(\\[  SKIPPED \\] [^\n]*\n)+$]=])
set(text "")
foreach(suite IN LISTS suites)
  string(APPEND text "add_test([=[${PREFIX}${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*]=])\n"
                     "set_tests_properties([=[${PREFIX}${suite}]=] PROPERTIES WORKING_DIRECTORY [=[${DIRECTORY}]=] "
                     "SKIP_REGULAR_EXPRESSION \"${skipped}\")\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
