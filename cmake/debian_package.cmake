# Makes a .deb of a build: the tree that `cmake --install` makes, below /usr.
#
# cmake -D BUILD_DIR=dir -D CONFIG=name -D OUTPUT=dir -P debian_package.cmake
cmake_minimum_required(VERSION 3.22...3.25)

file(REMOVE_RECURSE ${OUTPUT}/tree)
execute_process(
  COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --config "${CONFIG}" --prefix ${OUTPUT}/tree/usr --strip
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
# Debian requires of every package: the licence as `copyright`, and compressed changes and manual pages.
set(share ${OUTPUT}/tree/usr/share)
file(COPY_FILE ${share}/doc/robcogen/LICENSE ${share}/doc/robcogen/copyright)
file(RENAME ${share}/doc/robcogen/CHANGELOG.md ${share}/doc/robcogen/changelog)
# Debian's zsh looks in its own folder.
file(RENAME ${share}/zsh/site-functions ${share}/zsh/vendor-completions)
execute_process(COMMAND gzip --best --no-name ${share}/doc/robcogen/changelog ${share}/man/man1/robcogen.1 COMMAND_ERROR_IS_FATAL ANY)
# CPack would first build all targets, including robots and tests, so it is given the tree instead.
execute_process(
  COMMAND ${CMAKE_CPACK_COMMAND} -G DEB --config ${BUILD_DIR}/CPackConfig.cmake -B ${OUTPUT} -D CPACK_INSTALL_CMAKE_PROJECTS= -D
          "CPACK_INSTALLED_DIRECTORIES=${OUTPUT}/tree;/" COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${OUTPUT}/tree ${OUTPUT}/_CPack_Packages)
