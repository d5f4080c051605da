# Makes a .deb of a build: the tree that `cmake --install` makes, below /usr.
#
# cmake -D BUILD_DIR=dir -D CONFIG=name -D OUTPUT=dir -P debian_package.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${OUTPUT}/tree)
execute_process(
  COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --config "${CONFIG}" --prefix ${OUTPUT}/tree/usr --strip
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
# CPack would build all targets first, robots and tests among them; it takes the tree instead.
execute_process(
  COMMAND ${CMAKE_CPACK_COMMAND} -G DEB --config ${BUILD_DIR}/CPackConfig.cmake -B ${OUTPUT} -D CPACK_INSTALL_CMAKE_PROJECTS= -D
          "CPACK_INSTALLED_DIRECTORIES=${OUTPUT}/tree;/" COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${OUTPUT}/tree ${OUTPUT}/_CPack_Packages)
