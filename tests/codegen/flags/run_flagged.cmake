# Compiles flagged.cpp with flags that users have, links it with the comparison, which was compiled without them, and
# runs it.
#
# cmake -D COMPILER=path -D "FLAGS=flag flag" -D INCLUDES=dir,dir -D REFERENCE=compare.o -D WORK=file -P run_flagged.cmake
#
# Without FLAGS it compiles only the comparison, to REFERENCE.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

separate_arguments(flags UNIX_COMMAND "${FLAGS}")
list_includes(includes)
if(flags)
  run(output ${COMPILER} -std=c++17 ${warnings} ${flags} ${includes} -c ${CMAKE_CURRENT_LIST_DIR}/flagged.cpp -o ${WORK}.o)
  # Links with the same flags, as a build does: -ffast-math makes subnormal numbers zero in the whole program.
  run(output ${COMPILER} ${flags} ${REFERENCE} ${WORK}.o -o ${WORK})
  run(output ${WORK})
  message("${output}")
else()
  run(output ${COMPILER} -std=c++17 -O1 ${warnings} ${includes} -c ${CMAKE_CURRENT_LIST_DIR}/compare.cpp -o ${REFERENCE})
endif()
