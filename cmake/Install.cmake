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
