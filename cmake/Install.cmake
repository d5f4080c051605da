# The installed package: the files for find_package(robcogen) in other projects, and the generator.
include(CMakePackageConfigHelpers)

set(package_dir lib/cmake/robcogen)

install(DIRECTORY runtime/include/ tests/reference/include/ DESTINATION include)
install(DIRECTORY runtime/compatibility/ DESTINATION share/robcogen/compatibility)
# Documents are installed file by file: install(DIRECTORY) would also make empty folders where there is no document.
file(GLOB documents RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} robots/*/*.*dsl robots/*/parts/*.kindsl)
foreach(document IN LISTS documents)
  cmake_path(GET document PARENT_PATH folder)
  install(FILES ${document} DESTINATION share/robcogen/${folder})
endforeach()

# The Python package, and what pip needs to install it from there.
install(
  DIRECTORY runtime/python/robcogen runtime/python/_robcogen
  DESTINATION share/robcogen/python
  FILES_MATCHING
  PATTERN "*.py"
  PATTERN "py.typed")
install(FILES runtime/python/make_wheel.py runtime/python/pyproject.toml DESTINATION share/robcogen/python)
include(cmake/InstallPython.cmake)

install(TARGETS robcogen_runtime robcogen_iit robcogen_reference EXPORT robcogenTargets)
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
        cmake/RobcogenCompatibility.cmake
        cmake/RobcogenInstall.cmake
        cmake/RobcogenProcessors.cmake
        cmake/RobcogenPython.cmake
        cmake/RobcogenRos.cmake
        cmake/RobcogenTool.cmake
        cmake/RobcogenUnity.cmake
        cmake/RobcogenComplete.cmake
        cmake/RobcogenRealTime.cmake
        cmake/RobcogenTransforms.cmake
        cmake/RobcogenView.cmake
        cmake/RobcogenXacro.cmake
        cmake/RobcogenExpandXacro.cmake
        tool/algorithm/catalogue/groups.inc
        tool/backend/common/keywords.inc
        tool/backend/common/macros.inc
        tool/backend/common/globals.inc
  DESTINATION ${package_dir})

# A ROS 2 workspace finds the package by this file and this marker.
install(FILES package.xml DESTINATION share/robcogen)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/ament_index/robcogen "")
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ament_index/robcogen DESTINATION share/ament_index/resource_index/packages)

configure_file(cmake/robcogen.pc.in robcogen.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/robcogen.pc DESTINATION share/pkgconfig)
# The guides, in folders in which their links to each other are valid, and the examples that they describe.
install(FILES LICENSE CHANGELOG.md DESTINATION share/doc/robcogen)
file(GLOB guides RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} README.md CONTRIBUTING.md cmake/*.md runtime/*.md runtime/*/*.md bench/*.md bench/*.svg
     tool/*.md tool/*/*.md tool/*/*.svg tool/editors/*/*.md)
foreach(guide IN LISTS guides)
  cmake_path(GET guide PARENT_PATH folder)
  install(FILES ${guide} DESTINATION share/doc/robcogen/${folder})
endforeach()
install(DIRECTORY robots DESTINATION share/doc/robcogen PATTERN __pycache__ EXCLUDE PATTERN build EXCLUDE)
install(DIRECTORY tool/editors DESTINATION share/robcogen PATTERN "*.cpp" EXCLUDE PATTERN "*.md" EXCLUDE)

# What the generator prints about its own command line: the manual page, and completions in the folders of the shells.
if(TARGET robcogen)
  set(described ${PROJECT_BINARY_DIR}/described)
  install(FILES ${described}/robcogen.1 DESTINATION share/man/man1)
  install(FILES ${described}/robcogen.bash DESTINATION share/bash-completion/completions RENAME robcogen)
  install(FILES ${described}/robcogen.zsh DESTINATION share/zsh/site-functions RENAME _robcogen)
  install(FILES ${described}/robcogen.fish DESTINATION share/fish/vendor_completions.d)
endif()

# The targets robcogen_deb (a Debian package), robcogen_source (an archive of the sources) and uninstall.
if(PROJECT_IS_TOP_LEVEL)
  include(cmake/Release.cmake)
endif()
