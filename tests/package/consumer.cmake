# Configures, builds and runs one project of consumers/.
#
# cmake -D CONSUMER=name -D OPTIONS=list -D SOURCE_DIR=dir -D WORK_DIR=dir -P consumer.cmake
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(build_dir ${WORK_DIR}/${CONSUMER})
file(REMOVE_RECURSE ${build_dir})
run(output ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/${CONSUMER} -B ${build_dir} ${OPTIONS}
    -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBOTS_DIR=${SOURCE_DIR}/robots)
run(output ${CMAKE_COMMAND} --build ${build_dir} --parallel 2)
run(output ${build_dir}/controller)
message("${output}")
