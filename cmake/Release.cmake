# The targets of a release: a Debian package, an archive of the sources, a wheel and its sources, and uninstall.
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

# A wheel of the platform, and the sources as pip takes them.
find_package(Python3 3.11 QUIET COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND)
  if(TARGET robcogen)
    get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
    add_custom_target(
      robcogen_wheel
      COMMAND
        ${CMAKE_COMMAND} -DBUILD_DIR=${PROJECT_BINARY_DIR} -DCONFIG=$<CONFIG> -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
        -DOUTPUT=${PROJECT_BINARY_DIR}/wheel -DPYTHON=${Python3_EXECUTABLE} -DEIGEN=${eigen}
        -DLIBRARY_SOURCES=${ROBCOGEN_LIBRARY_SOURCES} -P ${CMAKE_CURRENT_LIST_DIR}/python_wheel.cmake
      DEPENDS robcogen
      VERBATIM)
  endif()
  add_custom_target(
    robcogen_sdist
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/runtime/python/make_wheel.py ${PROJECT_BINARY_DIR}/sdist --sources
            ${PROJECT_BINARY_DIR}/source/robcogen-${PROJECT_VERSION}.tar.gz
    VERBATIM)
  add_dependencies(robcogen_sdist robcogen_source)
endif()

add_custom_target(
  uninstall
  COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt -P ${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake
  VERBATIM)
