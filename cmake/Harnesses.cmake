# The programs that robcogen_add_robot compiles once for each robot. A harness is an interface target that carries its
# source, so that the function finds it alike in this tree and in an installed package.

# Makes robcogen::<name>_harness of `sources`, a list of a program and headers of its own; it includes those of the targets
# that follow, too.
function(robcogen_harness name sources)
  set(target robcogen_${name}_harness)
  add_library(${target} INTERFACE)
  add_library(robcogen::${name}_harness ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name}_harness)
  foreach(source IN LISTS sources)
    cmake_path(GET source FILENAME file)
    target_sources(
      ${target} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/${source}>
                          $<INSTALL_INTERFACE:share/robcogen/${name}/${file}>)
  endforeach()
  target_link_libraries(${target} INTERFACE ${ARGN})
  if(ROBCOGEN_INSTALL)
    install(FILES ${sources} DESTINATION share/robcogen/${name})
    install(TARGETS ${target} EXPORT robcogenTargets)
  endif()
endfunction()
