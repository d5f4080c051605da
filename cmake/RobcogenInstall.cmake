# robcogen_install_robots: installs robots as a CMake package of the calling project, which ROS 2 finds too.
#
#     robcogen_install_robots(
#       TARGETS hyl hyl_c demo…     # libraries that robcogen_add_robot and robcogen_add_transforms made, and other libraries of
#                                   # the project that link them
#       [PACKAGE name])             # without it, the name of the project
#
# Installs the libraries, their headers (file sets; with CMake 3.22, those below include roots), and
#     lib/cmake/<PACKAGE>/          <PACKAGE>Config.cmake, which finds robcogen, with the version of the project. Targets are
#                                   <PACKAGE>::hyl, …
#     share/<PACKAGE>/package.xml   if the project has one, together with the marker of ament's package index
# so that a folder with a package.xml, whose build type is `cmake`, is a package of a colcon workspace without ament_cmake.
include_guard(GLOBAL)

function(robcogen_install_robots)
  cmake_parse_arguments(PARSE_ARGV 0 library "" "PACKAGE" "TARGETS")
  set(library_CALL robcogen_install_robots)
  set(library_TARGET "")
  _robcogen_refuse_repeated(PACKAGE ${ARGV})
  _robcogen_check_parsed(TARGETS PACKAGE)
  if("${library_TARGETS}" STREQUAL "")
    _robcogen_refuse("TARGETS is missing")
  endif()
  if("${library_PACKAGE}" STREQUAL "")
    set(library_PACKAGE ${PROJECT_NAME})
  endif()
  include(GNUInstallDirs)
  set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/${library_PACKAGE})
  foreach(target IN LISTS library_TARGETS)
    if(NOT TARGET ${target})
      _robcogen_refuse("TARGETS: unknown target '${target}'")
    endif()
    _robcogen_install_library(${target})
  endforeach()
  install(EXPORT ${library_PACKAGE} NAMESPACE ${library_PACKAGE}:: FILE ${library_PACKAGE}Targets.cmake DESTINATION ${package_dir})

  set(files ${CMAKE_CURRENT_BINARY_DIR}/${library_PACKAGE}Config.cmake ${CMAKE_CURRENT_BINARY_DIR}/${library_PACKAGE}ConfigVersion.cmake)
  list(GET files 0 config)
  get_property(version GLOBAL PROPERTY ROBCOGEN_VERSION)
  file(
    CONFIGURE
    OUTPUT ${config}
    CONTENT "include(CMakeFindDependencyMacro)
find_dependency(robcogen @version@)
include(\${CMAKE_CURRENT_LIST_DIR}/@library_PACKAGE@Targets.cmake)
"
    @ONLY)
  set(version 0.0.0)
  if(PROJECT_VERSION)
    set(version ${PROJECT_VERSION})
  endif()
  include(CMakePackageConfigHelpers)
  list(GET files 1 version_file)
  write_basic_package_version_file(${version_file} VERSION ${version} COMPATIBILITY SameMajorVersion)
  install(FILES ${files} DESTINATION ${package_dir})

  if(EXISTS ${PROJECT_SOURCE_DIR}/package.xml)
    install(FILES ${PROJECT_SOURCE_DIR}/package.xml DESTINATION share/${library_PACKAGE})
    set(marker ${CMAKE_CURRENT_BINARY_DIR}/ament_index/${library_PACKAGE})
    file(WRITE ${marker} "")
    install(FILES ${marker} DESTINATION share/ament_index/resource_index/packages)
  endif()
endfunction()

# Installs a library as part of the export set library_PACKAGE.
function(_robcogen_install_library target)
  set(places ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION
             ${CMAKE_INSTALL_BINDIR})
  get_property(root TARGET ${target} PROPERTY ROBCOGEN_INCLUDE_ROOT)
  if(CMAKE_VERSION VERSION_LESS 3.23 AND root)
    install(TARGETS ${target} EXPORT ${library_PACKAGE} ${places} INCLUDES DESTINATION include)
    string(REGEX REPLACE "([][+.*()^$|?])" "\\\\\\1" pattern "${root}")
    install(
      DIRECTORY ${root}/
      DESTINATION include
      FILES_MATCHING
      PATTERN "*.h"
      PATTERN "*.hh"
      PATTERN "*.inc"
      REGEX "^${pattern}/(c|gpu|python)$" EXCLUDE)
    return()
  endif()
  get_property(sets TARGET ${target} PROPERTY HEADER_SETS)
  set(headers "")
  foreach(set IN LISTS sets)
    list(APPEND headers FILE_SET ${set} DESTINATION include)
  endforeach()
  install(TARGETS ${target} EXPORT ${library_PACKAGE} ${places} ${headers})
endfunction()
