# For a cross build: builds the generator for the build machine from this source tree, in a nested build.
include(ExternalProject)

set(host_tool_dir ${PROJECT_BINARY_DIR}/host-tool)
ExternalProject_Add(
  robcogen_host_tool
  PREFIX ${host_tool_dir}
  SOURCE_DIR ${PROJECT_SOURCE_DIR}
  CMAKE_ARGS -DCMAKE_BUILD_TYPE=Release -DCMAKE_RUNTIME_OUTPUT_DIRECTORY_RELEASE=${host_tool_dir} -DBUILD_TESTING=OFF
  BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --config Release --target robcogen
  BUILD_BYPRODUCTS ${host_tool_dir}/robcogen
  # Only the nested build knows whether a source of the generator has changed.
  BUILD_ALWAYS ON
  INSTALL_COMMAND "")

add_executable(robcogen::robcogen IMPORTED GLOBAL)
set_target_properties(robcogen::robcogen PROPERTIES IMPORTED_LOCATION ${host_tool_dir}/robcogen)
add_dependencies(robcogen::robcogen robcogen_host_tool)
