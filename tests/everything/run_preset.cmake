# Configures, builds and tests a preset.
#     PRESET      its name
#     SOURCE_DIR  the project
#     BINARY_DIR  the build folder
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${SOURCE_DIR} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} --preset ${PRESET} -B ${BINARY_DIR})
run(${CMAKE_COMMAND} --build ${BINARY_DIR})
run(${CMAKE_CTEST_COMMAND} --test-dir ${BINARY_DIR} --output-on-failure --parallel 2 --no-tests=error)
