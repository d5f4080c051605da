# The page that shows a robot and moves it: the target <robot>_view of robcogen_add_robot, which `all` does not contain.

# Adds the target. It takes only those OPTIONS that affect how a URDF is read, ROBOT, LOCK and KEEP.
function(_robcogen_add_view target)
  set(arguments "")
  foreach(dir IN LISTS library_IMPORT_DIRS)
    cmake_path(ABSOLUTE_PATH dir BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    list(APPEND arguments -I ${dir})
  endforeach()
  set(options ${library_OPTIONS})
  list(FILTER options INCLUDE REGEX "^--(free-mimic-joints|allow-implausible|snap-angles|floating-base|passive-forces)$")
  foreach(keyword FLOATING_BASE SNAP_ANGLES PASSIVE_FORCES)
    if(library_${keyword})
      string(TOLOWER "--${keyword}" option)
      string(REPLACE "_" "-" option ${option})
      list(APPEND options ${option})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES options)
  if(library_ROBOT)
    list(APPEND options --robot ${library_ROBOT})
  endif()
  _robcogen_change_arguments(changes)
  list(APPEND options ${changes})
  set(page ${library_OUTPUT_DIR}/${library_NAME}.html)
  # The command always runs, after the model exists; a page that would not change is left as it is.
  add_custom_target(
    ${target}
    COMMAND robcogen::robcogen view ${library_MODEL} -o ${page} ${arguments} ${options}
    BYPRODUCTS ${page}
    COMMENT "Page of ${library_NAME}: ${page}"
    VERBATIM)
  add_dependencies(${target} ${library_TARGET}_codegen)
  set_target_properties(${target} PROPERTIES FOLDER robots)
endfunction()
