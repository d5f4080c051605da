# The Debian package: what it depends on, and a robot that is built with what it holds, by pkg-config and by Python.
#
# cmake -D BUILD_DIR=dir -D CONFIG=name -D WORK_DIR=dir -D CXX_COMPILER=path -D SOURCE_DIR=dir -P debian.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
foreach(program dpkg-deb dpkg-shlibdeps pkg-config)
  find_program(found_${program} ${program})
  if(NOT found_${program})
    message(STATUS "skipped: there is no ${program}")
    return()
  endif()
endforeach()

set(dir ${WORK_DIR}/debian)
file(REMOVE_RECURSE ${dir})
run(output ${CMAKE_COMMAND} -DBUILD_DIR=${BUILD_DIR} -DCONFIG=${CONFIG} -DOUTPUT=${dir} -P ${SOURCE_DIR}/cmake/debian_package.cmake)
file(GLOB package ${dir}/robcogen_*.deb)
run(fields dpkg-deb --field ${package})
expect_words("fields" "${fields}" "Package: robcogen")
expect_words("fields" "${fields}" "libeigen3-dev")
expect_words("fields" "${fields}" "libc6")
run(output dpkg-deb --extract ${package} ${dir}/root)
set(prefix ${dir}/root/usr)
foreach(file bin/robcogen lib/cmake/robcogen/robcogenConfig.cmake share/doc/robcogen/LICENSE share/robcogen/python/robcogen/__init__.py)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "the package has no ${file}")
  endif()
endforeach()

# The variables of pkg-config follow the tree.
set(ENV{PKG_CONFIG_PATH} ${prefix}/share/pkgconfig)
run(tool pkg-config --variable=tool robcogen)
string(STRIP "${tool}" tool)
run(flags pkg-config --cflags robcogen)
separate_arguments(flags UNIX_COMMAND "${flags}")
set(robot ${prefix}/share/robcogen/robots/hyl/hyl.kindsl)
run(output ${tool} generate ${robot} --name hyl --algorithms inverse_dynamics -o ${dir}/generated)
file(WRITE ${dir}/main.cpp
     "#include <hyl/hyl.h>\nint main() { return hyl::inverse_dynamics({0, 0, 0}, {0, 0, 0}, {0, 0, 0})[0] > 73 ? 0 : 1; }\n")
run(output ${CXX_COMPILER} -std=c++17 ${flags} -I${dir}/generated ${dir}/main.cpp ${dir}/generated/hyl/inverse_dynamics.cpp
    ${dir}/generated/hyl/trigonometry.cpp -o ${dir}/main)
run(output ${dir}/main)

# Python, where it has its headers.
execute_process(
  COMMAND /usr/bin/python3 -c "import sysconfig, os; assert os.path.isfile(sysconfig.get_paths()['include'] + '/Python.h')"
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
if(status EQUAL 0)
  set(ENV{PYTHONPATH} ${prefix}/share/robcogen/python)
  set(ENV{PYTHONDONTWRITEBYTECODE} 1)
  set(ENV{ROBCOGEN_TOOL} ${tool})
  set(ENV{ROBCOGEN_CACHE} ${dir}/cache)
  run(output /usr/bin/python3 -m robcogen ${robot} --algorithms inverse_dynamics -o ${dir}/module)
  expect_words("module" "${output}" "hyl.abi3.so")
endif()
