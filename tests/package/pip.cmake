# What a user of pip does, without network: installs the package in a virtual environment, loads a robot, generates code,
# builds a project with CMake, uninstalls.
#
# cmake -D FROM=wheel|sources -D LIBRARY_SOURCES=dir -D BUILD_DIR=dir -D WORK_DIR=dir -D SOURCE_DIR=dir -D VERSION=1.0.0
#       -D CXX_COMPILER=path -P pip.cmake
# FROM: a wheel whose generator is linked statically, from the sources of libraries in LIBRARY_SOURCES; or the source
# distribution, from which pip builds the generator with the libraries of this machine.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(dir ${WORK_DIR}/pip_${FROM})
set(python ${dir}/environment/bin/python)
file(REMOVE_RECURSE ${dir}/environment ${dir}/files)
# The Python of Debian, which has NumPy for the comparison.
execute_process(
  COMMAND /usr/bin/python3 -m venv --system-site-packages ${dir}/environment OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message("skipped: /usr/bin/python3 makes no virtual environment (Debian: python3-venv)")
  return()
endif()
# Where the system lets it, commands run in a namespace without network.
set(offline unshare --map-root-user --net)
execute_process(COMMAND ${offline} true OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  set(offline "")
endif()
foreach(variable ROBCOGEN_TOOL PYTHONPATH CMAKE_PREFIX_PATH)
  unset(ENV{${variable}})
endforeach()
set(ENV{ROBCOGEN_CACHE} ${dir}/files/cache)
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
file(GLOB_RECURSE before LIST_DIRECTORIES true RELATIVE ${dir}/environment ${dir}/environment/*)

if(FROM STREQUAL "sources")
  run(output ${CMAKE_COMMAND} --build ${BUILD_DIR} --target robcogen_sdist)
  set(package ${BUILD_DIR}/sdist/robcogen-${VERSION}.tar.gz)
  # The test checks that the generator compiles, not how fast it runs.
  set(ENV{CMAKE_ARGS} "-DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_CXX_COMPILER=${CXX_COMPILER}")
else()
  if(NOT EXISTS ${LIBRARY_SOURCES})
    message("skipped: there are no sources of libraries in ${LIBRARY_SOURCES} (cmake/bootstrap.sh sources FOLDER)")
    return()
  endif()
  # The preset names its folder relative to the sources.
  run(output ${CMAKE_COMMAND} -E chdir ${SOURCE_DIR} ${CMAKE_COMMAND} --preset wheel -B ${dir}/build
      -DROBCOGEN_LIBRARY_SOURCES=${LIBRARY_SOURCES} -DCMAKE_CXX_COMPILER=${CXX_COMPILER})
  run(output ${CMAKE_COMMAND} --build ${dir}/build --target robcogen_wheel --parallel 2)
  file(GLOB package ${dir}/build/wheel/*.whl)
  cmake_host_system_information(RESULT machine QUERY OS_PLATFORM)
  cmake_path(GET package FILENAME name)
  expect_equal("name" "${name}" "robcogen-${VERSION}-py3-none-manylinux_2_17_${machine}.musllinux_1_1_${machine}.whl")
endif()
run(output ${offline} ${python} -m pip install --no-index --disable-pip-version-check ${package})

# The generator needs no file of the system: it runs in a folder that holds nothing else.
if(FROM STREQUAL "wheel" AND offline)
  file(GLOB generator ${dir}/environment/lib/python*/site-packages/robcogen/bin/robcogen)
  file(COPY ${generator} ${SOURCE_DIR}/robots/hyl/hyl.kindsl DESTINATION ${dir}/files/root)
  run(output ${offline} --root=${dir}/files/root /robcogen generate /hyl.kindsl -o /generated --name hyl)
  if(NOT EXISTS ${dir}/files/root/generated/hyl/hyl.h)
    message(FATAL_ERROR "the generator writes nothing in an empty root: ${output}")
  endif()
endif()

run(output ${offline} ${python} ${CMAKE_CURRENT_LIST_DIR}/pip/two_link_arm.py)
expect_words("comparison" "${output}" "compared with the textbook by ${dir}/environment")
run(output ${dir}/environment/bin/robcogen generate ${SOURCE_DIR}/robots/hyl/hyl.kindsl -o ${dir}/files/generated --name hyl)
if(NOT EXISTS ${dir}/files/generated/hyl/hyl.h)
  message(FATAL_ERROR "robcogen generate writes no hyl.h: ${output}")
endif()

# A project finds the CMake package, and where there is no Eigen, that of the wheel.
run(folder ${python} -m robcogen --cmake-dir)
string(STRIP "${folder}" folder)
run(output ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/find_package -B ${dir}/files/consumer -Drobcogen_DIR=${folder}
    -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DROBOTS_DIR=${SOURCE_DIR}/robots
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DBUILD_TESTING=OFF)
file(READ ${dir}/files/consumer/compile_commands.json commands)
expect_words("Eigen of the wheel" "${commands}" "-isystem ${dir}/environment/lib/")
string(FIND "${commands}" "/usr/include/eigen3" position)
expect_equal("Eigen of the system" "${position}" "-1")
run(output ${CMAKE_COMMAND} --build ${dir}/files/consumer --target controller --parallel 2)
run(output ${dir}/files/consumer/controller)

# An environment has afterwards what it had before.
run(output ${python} -m pip uninstall --yes --disable-pip-version-check robcogen)
file(GLOB_RECURSE after LIST_DIRECTORIES true RELATIVE ${dir}/environment ${dir}/environment/*)
expect_equal("files that are left" "${after}" "${before}")
