# Functions for the scripts of this folder.
set(warnings -Wall -Wextra -Wconversion -Wshadow -Werror)

function(run output)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE status)
  if(NOT status STREQUAL "0")
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${text}\nexit status ${status} of ${command}")
  endif()
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

# Returns INCLUDES as compiler options.
function(list_includes result)
  string(REPLACE "," ";" options "${INCLUDES}")
  list(TRANSFORM options PREPEND -I)
  set(${result} ${options} PARENT_SCOPE)
endfunction()
