# Generated text is formatted as the project's own: CLANG_FORMAT, STYLE (file), DIRECTORY.
file(GLOB_RECURSE files ${DIRECTORY}/*.h ${DIRECTORY}/*.cpp)
if(NOT files)
  message(FATAL_ERROR "no generated files in ${DIRECTORY}")
endif()
execute_process(
  COMMAND ${CLANG_FORMAT} --style=file:${STYLE} --dry-run --Werror ${files}
  RESULT_VARIABLE result
  ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "not formatted:\n${errors}")
endif()
