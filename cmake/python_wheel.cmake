# Makes the wheel of a build: the Python package with the generator, the headers, the CMake package and Eigen.
#
# cmake -D BUILD_DIR=dir -D CONFIG=name -D SOURCE_DIR=dir -D OUTPUT=dir -D PYTHON=path -D EIGEN=dir [-D LIBRARY_SOURCES=dir]
#       -P python_wheel.cmake
cmake_minimum_required(VERSION 3.22...3.25)

set(all ${OUTPUT}/installation)
set(prefix ${OUTPUT}/robcogen)
set(licenses ${OUTPUT}/licenses)
file(REMOVE_RECURSE ${OUTPUT})
execute_process(
  COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --config "${CONFIG}" --prefix ${all} --strip
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# What serves in the folder of a Python package: guides, completions and manual page are found in a prefix only.
file(COPY ${all}/bin ${all}/include DESTINATION ${prefix})
file(COPY ${all}/lib/cmake DESTINATION ${prefix}/lib)
file(COPY ${all}/share/robcogen DESTINATION ${prefix}/share PATTERN python EXCLUDE PATTERN editors EXCLUDE PATTERN package.xml EXCLUDE)
# The wheel brings Eigen because environments of Python have no package of its headers; robcogenConfig.cmake takes another
# Eigen if it finds one.
file(COPY ${EIGEN}/Eigen DESTINATION ${prefix}/share/robcogen/eigen3)

# The licences of what the generator links and the wheel brings. Debian has them beside its packages and in its sources.
file(COPY ${SOURCE_DIR}/LICENSE DESTINATION ${licenses})
foreach(library "fmt;libfmt-dev;fmt*" "urdfdom;liburdfdom-dev;urdfdom-[0-9]*" "urdfdom-headers;liburdfdom-headers-dev;urdfdom[-_]headers-*"
                "tinyxml;libtinyxml-dev;tinyxml-*" "console-bridge;libconsole-bridge-dev;console?bridge-*" "cli11;libcli11-dev;cli11-*"
                "nlohmann-json;nlohmann-json3-dev;nlohmann-json*" "eigen;libeigen3-dev;" "gcc;gcc-*-base;" "glibc;libc6;")
  list(GET library 0 name)
  list(GET library 1 package)
  list(GET library 2 folder)
  file(GLOB texts /usr/share/doc/${package}/copyright)
  if(LIBRARY_SOURCES AND folder)
    file(GLOB of_sources ${LIBRARY_SOURCES}/${folder}/debian/copyright ${LIBRARY_SOURCES}/${folder}/LICENSE*)
    list(PREPEND texts ${of_sources})
  endif()
  if(NOT texts)
    message(WARNING "The licence text of ${name} is missing: add it to the wheel before you publish it")
    continue()
  endif()
  list(GET texts 0 text)
  file(COPY_FILE ${text} ${licenses}/${name}.txt)
endforeach()
# Texts to which these refer.
foreach(text MPL-2.0 LGPL-2.1 GPL-3)
  if(EXISTS /usr/share/common-licenses/${text})
    file(COPY_FILE /usr/share/common-licenses/${text} ${licenses}/${text}.txt)
  endif()
endforeach()

execute_process(
  COMMAND ${PYTHON} ${SOURCE_DIR}/runtime/python/make_wheel.py ${OUTPUT} --installation ${prefix} --licenses ${licenses}
  COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${all} ${prefix} ${licenses})
