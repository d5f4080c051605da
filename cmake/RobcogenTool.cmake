# Finds the generator, in the source tree and in an installed package.
#
# It is the first of these: an existing target robcogen::robcogen; the executable that ROBCOGEN_HOST_TOOL names; in a native
# build the executable of the package; in a cross build a robcogen of this version on the PATH.

# Sets `result` to the version that `candidate --version` reports, or to "none" if it does not run.
function(_robcogen_tool_version candidate result)
  execute_process(
    COMMAND ${candidate} --version
    OUTPUT_VARIABLE answer
    ERROR_QUIET
    RESULT_VARIABLE status)
  if(status STREQUAL "0" AND answer MATCHES "[0-9]+\\.[0-9]+\\.[0-9]+")
    set(${result} "${CMAKE_MATCH_0}" PARENT_SCOPE)
  else()
    set(${result} "none" PARENT_SCOPE)
  endif()
endfunction()

# A validator for find_program: generated code and the runtime that it includes must have the same version.
function(_robcogen_refuse_other_version result candidate)
  get_property(wanted GLOBAL PROPERTY ROBCOGEN_VERSION)
  _robcogen_tool_version("${candidate}" version)
  if(NOT version STREQUAL wanted)
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()

function(_robcogen_import_tool path)
  get_property(wanted GLOBAL PROPERTY ROBCOGEN_VERSION)
  if(NOT IS_ABSOLUTE "${path}" OR NOT EXISTS "${path}")
    message(FATAL_ERROR "ROBCOGEN_HOST_TOOL must be the absolute path of a robcogen executable; it is '${path}'")
  endif()
  _robcogen_tool_version("${path}" version)
  if(NOT version STREQUAL wanted)
    message(FATAL_ERROR "ROBCOGEN_HOST_TOOL must be robcogen ${wanted}; '${path}' reports version ${version}")
  endif()
  add_executable(robcogen::robcogen IMPORTED GLOBAL)
  set_target_properties(robcogen::robcogen PROPERTIES IMPORTED_LOCATION "${path}")
endfunction()

# Defines robcogen::robcogen if an executable is found.
function(_robcogen_find_tool)
  if(TARGET robcogen::robcogen)
    return()
  endif()
  if(CMAKE_CROSSCOMPILING)
    # This searches only if the variable is not set.
    find_program(
      ROBCOGEN_HOST_TOOL robcogen
      VALIDATOR _robcogen_refuse_other_version
      NO_CMAKE_FIND_ROOT_PATH
      DOC "The robcogen executable to generate with")
  endif()
  if(ROBCOGEN_HOST_TOOL)
    _robcogen_import_tool("${ROBCOGEN_HOST_TOOL}")
  elseif(NOT CMAKE_CROSSCOMPILING)
    # This file exists only in an installed package.
    include(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/robcogenToolTargets.cmake OPTIONAL)
  endif()
endfunction()

function(_robcogen_require_tool)
  _robcogen_find_tool()
  if(NOT TARGET robcogen::robcogen)
    get_property(wanted GLOBAL PROPERTY ROBCOGEN_VERSION)
    message(
      FATAL_ERROR
        "No robcogen ${wanted} was found that runs on this machine. Set ROBCOGEN_HOST_TOOL to the path of one; "
        "from the source tree, ROBCOGEN_BUILD_HOST_TOOL=ON builds it.")
  endif()
endfunction()
