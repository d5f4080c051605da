# The libraries that the generator links. {fmt}, CLI11 and nlohmann-json are packages. URDFs are read with urdfdom, and with
# TinyXML for places in the text; MJCF is read with the same libraries.
#
# Where ROBCOGEN_LIBRARY_SOURCES names a folder of sources, {fmt}, urdfdom, and TinyXML and console_bridge, on which urdfdom
# builds, are compiled from these and linked statically: for wheels, for other systems, and for those that have no packages of
# them. The headers of CLI11 and nlohmann-json are taken from there too, or else are packages. `cmake/bootstrap.sh sources FOLDER`
# makes such a folder.
#
# Sets urdf_is_read, and urdf_includes and urdf_libraries if it is on; and assimp_is_linked, with assimp_includes and
# assimp_library.
set(ROBCOGEN_URDF AUTO CACHE STRING "Read URDFs, MJCF and SDF, with urdfdom: ON, OFF, or AUTO (where it is installed)")
set_property(CACHE ROBCOGEN_URDF PROPERTY STRINGS AUTO ON OFF)
set(ROBCOGEN_LIBRARY_SOURCES "" CACHE PATH "Folder of the sources of fmt, urdfdom, TinyXML and console_bridge, to link these statically")
set(ROBCOGEN_ASSIMP AUTO CACHE STRING "Read meshes in other formats than STL and OBJ, with assimp: ON, OFF, or AUTO (where it is installed)")
set_property(CACHE ROBCOGEN_ASSIMP PROPERTY STRINGS AUTO ON OFF)
option(ROBCOGEN_STATIC "Link the generator with static libraries only, that of C included" OFF)

find_package(Threads REQUIRED)

# Makes a library of headers from the sources, or finds its package.
function(_robcogen_headers package target pattern file)
  file(GLOB folders ${ROBCOGEN_LIBRARY_SOURCES}/${pattern})
  foreach(folder IN LISTS folders)
    if(ROBCOGEN_LIBRARY_SOURCES AND EXISTS ${folder}/include/${file})
      string(TOLOWER robcogen_${package} headers)
      add_library(${headers} INTERFACE)
      target_include_directories(${headers} SYSTEM INTERFACE ${folder}/include)
      add_library(${target} ALIAS ${headers})
      return()
    endif()
  endforeach()
  find_package(${package} REQUIRED)
endfunction()
_robcogen_headers(CLI11 CLI11::CLI11 "cli11-*" CLI/CLI.hpp)
_robcogen_headers(nlohmann_json nlohmann_json::nlohmann_json "nlohmann-json*" nlohmann/json.hpp)

# Sets `result` to the folder of one library's sources, which is called like the library and its version.
function(_robcogen_sources pattern file result)
  file(GLOB folders ${ROBCOGEN_LIBRARY_SOURCES}/${pattern})
  foreach(folder IN LISTS folders)
    if(EXISTS ${folder}/${file})
      set(${result} ${folder} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "ROBCOGEN_LIBRARY_SOURCES is '${ROBCOGEN_LIBRARY_SOURCES}', which has no ${pattern}/${file}: "
                      "`cmake/bootstrap.sh sources FOLDER` brings the sources")
endfunction()

# A static library from the sources of others, whose warnings are not ours.
function(_robcogen_library target)
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${ARGN})
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-w>)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES COMPILE_WARNING_AS_ERROR OFF CXX_CLANG_TIDY "" UNITY_BUILD OFF)
endfunction()

# Not by its CMake package, which needs packages that Debian does not install with it.
set(assimp_is_linked OFF)
if(ROBCOGEN_ASSIMP AND NOT ROBCOGEN_LIBRARY_SOURCES AND NOT ROBCOGEN_STATIC)
  find_path(ROBCOGEN_ASSIMP_INCLUDE_DIR assimp/Importer.hpp)
  find_library(ROBCOGEN_ASSIMP_LIBRARY assimp)
  mark_as_advanced(ROBCOGEN_ASSIMP_INCLUDE_DIR ROBCOGEN_ASSIMP_LIBRARY)
  if(ROBCOGEN_ASSIMP_INCLUDE_DIR AND ROBCOGEN_ASSIMP_LIBRARY)
    set(assimp_is_linked ON)
    set(assimp_includes ${ROBCOGEN_ASSIMP_INCLUDE_DIR})
    set(assimp_library ${ROBCOGEN_ASSIMP_LIBRARY})
  elseif(NOT ROBCOGEN_ASSIMP STREQUAL "AUTO")
    message(FATAL_ERROR "ROBCOGEN_ASSIMP is ${ROBCOGEN_ASSIMP}, but assimp is missing (Debian: libassimp-dev)")
  endif()
endif()

set(urdf_is_read OFF)
if(NOT ROBCOGEN_LIBRARY_SOURCES)
  find_package(fmt REQUIRED)
  if(ROBCOGEN_URDF)
    find_package(urdfdom QUIET)
    find_path(ROBCOGEN_TINYXML_INCLUDE_DIR tinyxml.h)
    find_library(ROBCOGEN_TINYXML_LIBRARY tinyxml)
    mark_as_advanced(ROBCOGEN_TINYXML_INCLUDE_DIR ROBCOGEN_TINYXML_LIBRARY)
    if(urdfdom_FOUND AND ROBCOGEN_TINYXML_INCLUDE_DIR AND ROBCOGEN_TINYXML_LIBRARY)
      set(urdf_is_read ON)
      set(urdf_includes ${urdfdom_INCLUDE_DIRS} ${ROBCOGEN_TINYXML_INCLUDE_DIR})
      set(urdf_libraries ${urdfdom_LIBRARIES} ${ROBCOGEN_TINYXML_LIBRARY})
    elseif(NOT ROBCOGEN_URDF STREQUAL "AUTO")
      message(FATAL_ERROR "ROBCOGEN_URDF is ${ROBCOGEN_URDF}, but urdfdom or TinyXML is missing "
                          "(Debian: liburdfdom-dev, libtinyxml-dev)")
    else()
      message(STATUS "URDFs, MJCF and SDF will not be read: urdfdom or TinyXML is missing (Debian: liburdfdom-dev, libtinyxml-dev)")
    endif()
  endif()
  return()
endif()

_robcogen_sources("fmt*" src/format.cc fmt_dir)
_robcogen_library(robcogen_fmt ${fmt_dir}/src/format.cc)
target_include_directories(robcogen_fmt SYSTEM PUBLIC ${fmt_dir}/include)
add_library(fmt::fmt ALIAS robcogen_fmt)
if(NOT ROBCOGEN_URDF)
  return()
endif()

_robcogen_sources("tinyxml-*" tinyxml.h tinyxml_dir)
_robcogen_library(robcogen_tinyxml ${tinyxml_dir}/tinyxml.cpp ${tinyxml_dir}/tinyxmlparser.cpp ${tinyxml_dir}/tinyxmlerror.cpp
                  ${tinyxml_dir}/tinystr.cpp)
target_include_directories(robcogen_tinyxml SYSTEM PUBLIC ${tinyxml_dir})
target_compile_definitions(robcogen_tinyxml PUBLIC TIXML_USE_STL)

_robcogen_sources("console?bridge-*" src/console.cpp console_bridge_dir)
_robcogen_library(robcogen_console_bridge ${console_bridge_dir}/src/console.cpp)
# Its own build makes this header.
set(export_header ${CMAKE_CURRENT_BINARY_DIR}/console_bridge)
file(CONFIGURE OUTPUT ${export_header}/console_bridge_export.h
     CONTENT "#pragma once\n#define CONSOLE_BRIDGE_DLLAPI\n#define CONSOLE_BRIDGE_EXPORT\n#define CONSOLE_BRIDGE_DEPRECATED\n")
target_include_directories(robcogen_console_bridge SYSTEM PUBLIC ${console_bridge_dir}/include ${export_header})

_robcogen_sources("urdfdom[-_]headers-*" urdf_model/include/urdf_model/model.h urdf_headers_dir)
_robcogen_sources("urdfdom-[0-9]*" urdf_parser/src/model.cpp urdfdom_dir)
set(parser ${urdfdom_dir}/urdf_parser)
_robcogen_library(robcogen_urdfdom ${parser}/src/model.cpp ${parser}/src/link.cpp ${parser}/src/joint.cpp ${parser}/src/pose.cpp)
file(GLOB urdf_headers ${urdf_headers_dir}/*/include)
target_include_directories(robcogen_urdfdom SYSTEM PUBLIC ${parser}/include ${urdf_headers})
target_compile_definitions(robcogen_urdfdom PUBLIC URDFDOM_STATIC)
target_link_libraries(robcogen_urdfdom PUBLIC robcogen_tinyxml robcogen_console_bridge)
set(urdf_is_read ON)
set(urdf_includes "")
set(urdf_libraries robcogen_urdfdom)
