# Robots and their self-checks in projects that compile everything with these flags.
#
# cmake -D "FLAGS=flag flag" -D CXX_COMPILER=path -D TOOL=robcogen -D SOURCE_DIR=dir -D WORK_DIR=dir -P flags.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

cmake_path(GET CXX_COMPILER FILENAME compiler)
string(MAKE_C_IDENTIFIER "flags_${compiler}_${FLAGS}" name)
set(build_dir ${WORK_DIR}/${name})
file(REMOVE_RECURSE ${build_dir})
run(output ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/flags -B ${build_dir}
    -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBCOGEN_HOST_TOOL=${TOOL} -DROBOTS_DIR=${SOURCE_DIR}/robots
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_BUILD_TYPE= "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(output ${CMAKE_COMMAND} --build ${build_dir} --parallel 2 --target hyl_selfcheck quadruped_selfcheck)
run(output ${CMAKE_CTEST_COMMAND} --test-dir ${build_dir} -R selfcheck --no-tests=error --output-on-failure)
expect_words("tests" "${output}" "100% tests passed, 0 tests failed out of 2")
