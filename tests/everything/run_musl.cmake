# Compiles the C code of two robots with musl, statically, and runs the program that calls them.
#     MUSL_GCC    the compiler; if it is missing, the test is skipped, or fails if REQUIRED is set
#     TOOL        the generator
#     SOURCE_DIR  the project
#     FOLDER      for generated and compiled files
if(NOT MUSL_GCC)
  if(REQUIRED)
    message(FATAL_ERROR "musl-gcc is missing (Debian: musl-tools)")
  endif()
  message(NOTICE "skipped: musl-gcc is missing")
  return()
endif()
file(REMOVE_RECURSE ${FOLDER})
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${TOOL} generate ${SOURCE_DIR}/robots/hyl/hyl.kindsl -o ${FOLDER} --name hyl --namespace in_c --language c --algorithms
    inverse_dynamics forward_dynamics)
run(${TOOL} generate ${SOURCE_DIR}/robots/euler/euler.motdsl -o ${FOLDER} --name euler_in_c --language c)
file(GLOB_RECURSE sources ${FOLDER}/*.c)
run(${MUSL_GCC} -static -std=c99 -pedantic -Werror -O1 -I${FOLDER}/c ${sources}
    ${SOURCE_DIR}/tests/backends/c/program.c -lm -o ${FOLDER}/program)
run(${FOLDER}/program)
