# Configures, builds and runs one project of consumers/.
#
# cmake -D CONSUMER=name [-D PREFIX=dir] -D TOOL=robcogen -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir
#       -P consumer.cmake
# PREFIX is the prefix of the installed package, which contains its own generator.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

if(PREFIX)
  set(robcogen -DCMAKE_PREFIX_PATH=${PREFIX})
else()
  set(robcogen -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBCOGEN_HOST_TOOL=${TOOL})
endif()

set(build_dir ${WORK_DIR}/${CONSUMER})
file(REMOVE_RECURSE ${build_dir})
run(output ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/${CONSUMER} -B ${build_dir} ${robcogen}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DROBOTS_DIR=${SOURCE_DIR}/robots)
# Kernels for a processor are compiled with its flags, wherever the CMake functions come from.
file(STRINGS ${build_dir}/compile_commands.json commands REGEX "\"command\".*/kernels_avx2_1\\.cpp")
foreach(command IN LISTS commands)
  expect_words("options of the kernels for AVX2" "${command}" "-mavx2 -mfma")
endforeach()
cmake_host_system_information(RESULT processor QUERY OS_PLATFORM)
if(processor MATCHES "^(x86_64|AMD64)$" AND NOT commands)
  message(FATAL_ERROR "${build_dir}/compile_commands.json names no kernels for AVX2")
endif()
run(output ${CMAKE_COMMAND} --build ${build_dir} --parallel 2)
run(output ${build_dir}/controller)
message("${output}")
