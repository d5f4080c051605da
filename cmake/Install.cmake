# The installed package: the files for find_package(robcogen) in other projects, and the generator.
include(CMakePackageConfigHelpers)

set(package_dir lib/cmake/robcogen)

install(DIRECTORY runtime/include/ tests/reference/include/ DESTINATION include)
install(
  DIRECTORY robots
  DESTINATION share/robcogen
  FILES_MATCHING
  PATTERN "*.kindsl"
  PATTERN "*.dtdsl"
  PATTERN "*.motdsl"
  PATTERN "*.ctdsl"
  PATTERN demo EXCLUDE)

install(
  DIRECTORY runtime/python/robcogen
  DESTINATION share/robcogen/python
  FILES_MATCHING
  PATTERN "*.py")

install(TARGETS robcogen_runtime robcogen_reference EXPORT robcogenTargets)
install(EXPORT robcogenTargets NAMESPACE robcogen:: DESTINATION ${package_dir})
# A separate export set: a cross build reads the targets above, but not the executable for another machine.
if(TARGET robcogen)
  install(TARGETS robcogen EXPORT robcogenToolTargets RUNTIME DESTINATION bin)
  install(EXPORT robcogenToolTargets NAMESPACE robcogen:: DESTINATION ${package_dir})
endif()

configure_package_config_file(cmake/robcogenConfig.cmake.in robcogenConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(robcogenConfigVersion.cmake COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(
  FILES ${CMAKE_CURRENT_BINARY_DIR}/robcogenConfig.cmake
        ${CMAKE_CURRENT_BINARY_DIR}/robcogenConfigVersion.cmake
        cmake/Robcogen.cmake
        cmake/RobcogenArguments.cmake
        cmake/RobcogenC.cmake
        cmake/RobcogenProcessors.cmake
        cmake/RobcogenPython.cmake
        cmake/RobcogenTool.cmake
        cmake/RobcogenComplete.cmake
        cmake/RobcogenRealTime.cmake
        cmake/RobcogenTransforms.cmake
        cmake/RobcogenView.cmake
        cmake/RobcogenXacro.cmake
        cmake/RobcogenExpandXacro.cmake
        tool/backend/cpp/macros.inc
        tool/backend/cpp/globals.inc
  DESTINATION ${package_dir})

configure_file(cmake/robcogen.pc.in robcogen.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/robcogen.pc DESTINATION share/pkgconfig)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION share/doc/robcogen)
install(FILES runtime/README.md DESTINATION share/doc/robcogen/runtime)
install(FILES cmake/README.md DESTINATION share/doc/robcogen/cmake)

# The target robcogen_deb: a Debian package.
if(PROJECT_IS_TOP_LEVEL AND TARGET robcogen)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_NAME robcogen)
  set(CPACK_PACKAGE_CONTACT "The RobCoGen developers <robcogen@localhost>")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Generator of kinematics and dynamics of robots in C++, C, Python and other languages")
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SECTION devel)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "libeigen3-dev, g++")
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "cmake (>= 3.25)")
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-dev, python3-numpy")
  include(CPack)
  add_custom_target(
    robcogen_deb
    COMMAND ${CMAKE_COMMAND} -DBUILD_DIR=${PROJECT_BINARY_DIR} -DCONFIG=$<CONFIG> -DOUTPUT=${PROJECT_BINARY_DIR}/debian -P
            ${CMAKE_CURRENT_LIST_DIR}/debian_package.cmake
    DEPENDS robcogen
    VERBATIM)
endif()
