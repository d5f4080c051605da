# A robot from xacro: robcogen_add_robot(… MODEL arm.urdf.xacro XACRO_ARGS length:=0.7).
#
# The program is the one that ROBCOGEN_XACRO names, otherwise the xacro on the PATH. Included files are dependencies of the
# build, which are found at each expansion, because the configuration does not run xacro.

# Sets `result` to whether this file needs xacro.
function(_robcogen_is_xacro file result)
  cmake_path(GET file EXTENSION LAST_ONLY extension)
  if(extension STREQUAL ".xacro")
    set(${result} TRUE PARENT_SCOPE)
  else()
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()

function(_robcogen_require_xacro)
  find_program(ROBCOGEN_XACRO xacro DOC "The program that expands MODEL arm.urdf.xacro")
  if(NOT ROBCOGEN_XACRO)
    _robcogen_refuse(
      "MODEL needs xacro, which is not on the PATH: ${library_MODEL}. Install it (ROS: ros-<distribution>-xacro, \
and source its setup.bash) or set ROBCOGEN_XACRO to its path")
  endif()
endfunction()

# Sets `result` to the folder of the expanded file: OUTPUT_DIR below the build folder, and otherwise the default OUTPUT_DIR.
# Folders of sources may contain a file of this name that is not a result of the build.
function(_robcogen_folder_of_expansion result)
  set(folder ${library_OUTPUT_DIR})
  file(REAL_PATH "${folder}" real)
  file(REAL_PATH "${CMAKE_BINARY_DIR}" build)
  file(REAL_PATH "${CMAKE_SOURCE_DIR}" source)
  cmake_path(IS_PREFIX build "${real}" NORMALIZE is_below_build)
  if(NOT is_below_build OR build STREQUAL source)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/robcogen.gen/${library_TARGET})
  endif()
  set(${result} ${folder} PARENT_SCOPE)
endfunction()

# Adds the rule that expands library_MODEL, and sets library_MODEL to the result.
function(_robcogen_expand_xacro)
  _robcogen_require_xacro()
  cmake_path(GET library_MODEL STEM LAST_ONLY stem)
  string(REGEX REPLACE "\\.urdf$" "" stem "${stem}")
  _robcogen_folder_of_expansion(folder)
  set(expanded ${folder}/${stem}.urdf)
  cmake_path(GET library_MODEL FILENAME document)
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/RobcogenExpandXacro.cmake)
  add_custom_command(
    OUTPUT ${expanded}
    COMMAND ${CMAKE_COMMAND} -D XACRO=${ROBCOGEN_XACRO} -D MODEL=${library_MODEL} -D OUTPUT=${expanded} -P ${script} --
            ${library_XACRO_ARGS}
    DEPENDS ${library_MODEL} ${script} ${library_DEPENDS}
    DEPFILE ${expanded}.d
    COMMENT "Expanding ${document}"
    VERBATIM)
  set(library_MODEL ${expanded} PARENT_SCOPE)
endfunction()
