# COMPATIBILITY of robcogen_add_robot: the headers of the first RobCoGen over the library.

# Checks COMPATIBILITY, INCLUDE_PATH and COMPATIBILITY_RUNTIME, and sets the default of INCLUDE_PATH.
function(_robcogen_check_compatibility)
  if("${library_COMPATIBILITY}" STREQUAL "")
    foreach(keyword INCLUDE_PATH COMPATIBILITY_RUNTIME)
      if(NOT "${library_${keyword}}" STREQUAL "")
        _robcogen_refuse("${keyword} needs COMPATIBILITY")
      endif()
    endforeach()
    return()
  endif()
  _robcogen_check_elements(COMPATIBILITY robcogen)
  _robcogen_check_elements(COMPATIBILITY_RUNTIME own)
  if("${library_INCLUDE_PATH}" STREQUAL "")
    string(TOLOWER "iit/robots/${library_NAME}" library_INCLUDE_PATH)
  endif()
  if(NOT "${library_INCLUDE_PATH}" MATCHES "^[A-Za-z0-9_-]+(/[A-Za-z0-9_-]+)*$")
    _robcogen_refuse("INCLUDE_PATH is a folder as #include lines name it, such as iit/robots/hyq, not '${library_INCLUDE_PATH}'")
  endif()
  set(library_INCLUDE_PATH ${library_INCLUDE_PATH} PARENT_SCOPE)
endfunction()

# Sets `result` to the groups of functions that the headers call.
function(_robcogen_compatibility_groups result)
  set(${result} inverse_dynamics bias_forces forward_dynamics joint_space_inertia joint_space_inertia_factor centroidal
      transforms jacobians PARENT_SCOPE)
endfunction()

# Sets `headers` to the headers, relative to the include root; empty without COMPATIBILITY.
function(_robcogen_compatibility_files folder headers)
  set(list "")
  if(library_COMPATIBILITY)
    set(list ${folder}/kernel/compiled.h)
    foreach(file robot.h transforms.inc jacobians.inc)
      list(APPEND list ${library_INCLUDE_PATH}/detail/${file})
    endforeach()
    foreach(stem declarations kinematics_parameters dynamics_parameters default_dynparams_getter transforms jacobians
                 inertia_properties inverse_dynamics link_data_map joint_data_map rbd_types model_constants forward_dynamics
                 jsim miscellaneous traits)
      list(APPEND list ${library_INCLUDE_PATH}/${stem}.h)
    endforeach()
  endif()
  set(${headers} ${list} PARENT_SCOPE)
endfunction()

function(_robcogen_link_compatibility)
  if("${library_COMPATIBILITY_RUNTIME}" STREQUAL "own")
    target_link_libraries(${library_TARGET} PUBLIC robcogen::iit)
  endif()
endfunction()
