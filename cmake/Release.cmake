# The targets of a release: a Debian package, an archive of the sources, and uninstall.
set(CPACK_PACKAGE_NAME robcogen)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Generator of kinematics and dynamics of robots in C++, C, Python and other languages")

# The maintainer is taken from the same variables as by Debian's own tools.
set(maintainer "RobCoGen developers")
set(address "robcogen@example.org")
if(NOT "$ENV{DEBFULLNAME}" STREQUAL "" AND NOT "$ENV{DEBEMAIL}" STREQUAL "")
  set(maintainer "$ENV{DEBFULLNAME}")
  set(address "$ENV{DEBEMAIL}")
endif()
set(ROBCOGEN_MAINTAINER "${maintainer} <${address}>" CACHE STRING "Maintainer of the Debian package, Name <address>")
set(CPACK_PACKAGE_CONTACT "${ROBCOGEN_MAINTAINER}")

set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libeigen3-dev, g++")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "cmake (>= 3.22)")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-dev, python3-numpy")

# Patterns begin with a slash, so that they do not match files whose names only end like them.
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME robcogen-${PROJECT_VERSION})
set(CPACK_SOURCE_IGNORE_FILES "${PROJECT_SOURCE_DIR}/build[^/]*/" "/[.]git/" "${PROJECT_SOURCE_DIR}/[.]git$" "/[.]cache/"
                              "/compile_commands[.]json$" "/__pycache__/")
include(CPack)

if(TARGET robcogen)
  add_custom_target(
    robcogen_deb
    COMMAND ${CMAKE_COMMAND} -DBUILD_DIR=${PROJECT_BINARY_DIR} -DCONFIG=$<CONFIG> -DOUTPUT=${PROJECT_BINARY_DIR}/debian -P
            ${CMAKE_CURRENT_LIST_DIR}/debian_package.cmake
    DEPENDS robcogen
    VERBATIM)
endif()
add_custom_target(
  robcogen_source
  COMMAND ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackSourceConfig.cmake -B ${PROJECT_BINARY_DIR}/source
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/source/_CPack_Packages
  VERBATIM)
add_custom_target(
  uninstall
  COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt -P ${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake
  VERBATIM)
