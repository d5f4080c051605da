# Makes pages of the interface of the runtime and of a sample robot: FOLDER/html/index.html. A warning is an error.
#     DOXYGEN     the program; if it is missing, nothing is made
#     TOOL        the generator
#     SOURCE_DIR  the project
#     VERSION     of the project
#     FOLDER      for the pages and the sample
if(NOT DOXYGEN)
  message(NOTICE "skipped: doxygen is missing")
  return()
endif()
file(REMOVE_RECURSE ${FOLDER})
set(hyl ${SOURCE_DIR}/robots/hyl/hyl)
execute_process(
  COMMAND ${TOOL} generate ${hyl}.kindsl --desired ${hyl}.dtdsl --name hyl -o ${FOLDER}/sample --algorithms all --contacts fr_foot
          --batch COMMAND_ERROR_IS_FATAL ANY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${FOLDER}/Doxyfile @ONLY)
execute_process(COMMAND ${DOXYGEN} ${FOLDER}/Doxyfile COMMAND_ERROR_IS_FATAL ANY)
