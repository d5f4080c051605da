# Checks that generated text is formatted like the project's own. Variables: CLANG_FORMAT, STYLE (file), DIRECTORIES.
set(files "")
foreach(directory IN LISTS DIRECTORIES)
  file(GLOB_RECURSE found ${directory}/*.h ${directory}/*.inc ${directory}/*.cpp)
  if(NOT found)
    message(FATAL_ERROR "no generated files in ${directory}")
  endif()
  list(APPEND files ${found})
endforeach()
execute_process(
  COMMAND ${CLANG_FORMAT} --style=file:${STYLE} --dry-run --Werror ${files}
  RESULT_VARIABLE result
  ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "not formatted:\n${errors}")
endif()
