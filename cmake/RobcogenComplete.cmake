# The second rule of generation: runs the generator again when a generated file was removed, and touches COMPLETE.
#
# cmake -D EXPECTED=file -D COMPLETE=file -P RobcogenComplete.cmake generator argument…
#
# EXPECTED holds the list of all files.
cmake_minimum_required(VERSION 3.22...3.25)

file(READ ${EXPECTED} files)
foreach(file IN LISTS files)
  if(NOT EXISTS "${file}")
    # The arguments after the name of this script: cmake -D… -D… -P script generator argument…
    set(command "")
    math(EXPR last "${CMAKE_ARGC} - 1")
    foreach(i RANGE 5 ${last})
      list(APPEND command "${CMAKE_ARGV${i}}")
    endforeach()
    execute_process(COMMAND ${command} COMMAND_ERROR_IS_FATAL ANY)
    break()
  endif()
endforeach()
file(TOUCH "${COMPLETE}")
