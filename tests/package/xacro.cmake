# A robot of two xacro files: its expansion, and the steps that a build repeats after each kind of change.
#
# cmake -D GENERATOR=name -D TOOL=robcogen -D SOURCE_DIR=dir -D WORK_DIR=dir -P xacro.cmake
#
# The folder names contain blanks. A script with the features that these files need replaces xacro.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(consumer_dir ${CMAKE_CURRENT_LIST_DIR}/consumers/xacro)
set(work_dir "${WORK_DIR}/xacro ${GENERATOR}")
set(model_dir "${work_dir}/my robot")
set(build_dir "${work_dir}/build")
set(log "${work_dir}/log")
set(ENV{ROBCOGEN_TEST_LOG} "${log}")

set(output_dir generated)
function(configure length)
  run(output ${CMAKE_COMMAND} -G ${GENERATOR} -S ${consumer_dir} -B "${build_dir}" -DROBCOGEN_HOST_TOOL=${TOOL}
      -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DVERSION=${VERSION} "-DROBCOGEN_XACRO=${work_dir}/xacro"
      "-DMODEL_DIR=${model_dir}" -DLENGTH=${length} "-DOUTPUT_DIR=${output_dir}")
endfunction()

# Builds and compares the number of xacro runs.
function(expect_build event times)
  file(WRITE "${log}" "")
  run(output ${CMAKE_COMMAND} --build "${build_dir}")
  file(STRINGS "${log}" calls)
  list(LENGTH calls count)
  expect_equal("${GENERATOR}, ${event}: runs of xacro" ${count} ${times})
endfunction()

function(expect_in_urdf text)
  file(READ "${build_dir}/generated/arm.urdf" urdf)
  expect_words("the expanded file" "${urdf}" "${text}")
endfunction()

# Sets `result` to the model's hash, which the stamp contains.
function(model_hash result)
  file(READ "${build_dir}/generated/arm.stamp" hash)
  set(${result} "${hash}" PARENT_SCOPE)
endfunction()

function(edit file from to)
  # File system clocks tick in steps of up to 10 ms.
  execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 0.05)
  file(READ "${model_dir}/${file}" text)
  string(REPLACE "${from}" "${to}" edited "${text}")
  file(WRITE "${model_dir}/${file}" "${edited}")
endfunction()

file(REMOVE_RECURSE "${work_dir}")
file(COPY ${consumer_dir}/arm.urdf.xacro ${consumer_dir}/lower.xacro DESTINATION "${model_dir}")
file(COPY ${consumer_dir}/xacro DESTINATION "${work_dir}")
configure(0.75)
expect_build("first build" 1)
expect_in_urdf("xyz=\"0.75 0 0\"")
expect_in_urdf("<mass value=\"1.5\"/>")
model_hash(first)
expect_build("nothing changed" 0)

edit(lower.xacro "0.125 0 0" "0.25 0 0")
expect_build("an included file edited" 1)
expect_in_urdf("xyz=\"0.25 0 0\"")
model_hash(second)
if(first STREQUAL second)
  message(FATAL_ERROR "${GENERATOR}: nothing was generated of the edited file")
endif()
expect_build("nothing changed since" 0)

configure(0.5)
expect_build("another argument" 1)
expect_in_urdf("xyz=\"0.5 0 0\"")

edit(lower.xacro "<link name=\"lower\">" "<link name=\"lower\"")
run_failing(output ${CMAKE_COMMAND} --build "${build_dir}")
expect_words("a wrong file" "${output}" "[not-xml]")
edit(lower.xacro "<link name=\"lower\"" "<link name=\"lower\">")

# Beside the sources there is a file with the name of the expanded one, which must remain.
file(WRITE "${model_dir}/arm.urdf" "not a result")
set(output_dir "${model_dir}")
configure(0.5)
expect_build("output beside the sources" 1)
file(READ "${model_dir}/arm.urdf" kept)
expect_equal("${GENERATOR}: the file beside the sources" "${kept}" "not a result")

# The script alone refuses to replace what xacro reads, and does not follow links to it.
set(expand ${CMAKE_COMMAND} -D "XACRO=${work_dir}/xacro" -D "MODEL=${model_dir}/arm.urdf.xacro")
set(script -P ${SOURCE_DIR}/cmake/RobcogenExpandXacro.cmake --)
file(READ "${model_dir}/lower.xacro" lower)
foreach(output arm.urdf.xacro lower.xacro)
  run_failing(message ${expand} -D "OUTPUT=${model_dir}/${output}" ${script})
  expect_words("${output} as output" "${message}" "the output would replace the input")
endforeach()
file(CREATE_LINK "${model_dir}/lower.xacro" "${work_dir}/hard.urdf")
run(message ${expand} -D "OUTPUT=${work_dir}/hard.urdf" ${script})
file(READ "${model_dir}/lower.xacro" kept)
expect_equal("${GENERATOR}: the included file" "${kept}" "${lower}")
