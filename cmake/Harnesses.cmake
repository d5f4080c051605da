# The programs that robcogen_add_robot compiles once for each robot. A harness is an interface target that carries its
# source, so that the function finds it in this tree and in an installed package.

# Defines robcogen::<name>_harness from `sources`, which are a program and its headers. The program also includes the
# headers of the targets that follow.
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
