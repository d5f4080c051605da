# The project consumers/urdf, and the messages of its configuration and build.
#
# cmake -D TOOL=robcogen -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir -P urdf.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(build_dir ${WORK_DIR}/urdf)
file(REMOVE_RECURSE ${build_dir})
run(output ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/urdf -B ${build_dir}
    -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBCOGEN_HOST_TOOL=${TOOL} -DCMAKE_CXX_COMPILER=${CXX_COMPILER})
# Serial build, so that the messages of the two robots do not mix.
run(output ${CMAKE_COMMAND} --build ${build_dir} --target arm_codegen)
expect_words("near angles" "${output}" "3 angles of this robot are within 1e-6 of a multiple of PI/12")
run(output ${CMAKE_COMMAND} --build ${build_dir} --target flying_arm_codegen)
expect_words("snapped angles" "${output}" "[angle-snapped]")
run(output ${CMAKE_COMMAND} --build ${build_dir} --parallel 2)
run(output ${build_dir}/user)
run(output ${CMAKE_CTEST_COMMAND} --test-dir ${build_dir} --no-tests=error)
expect_words("tests" "${output}" "100% tests passed, 0 tests failed out of 6")
