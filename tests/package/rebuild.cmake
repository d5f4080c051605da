# The steps that a build repeats after each kind of change.
#
# cmake -D GENERATOR=name -D TOOL=robcogen -D SOURCE_DIR=dir -D WORK_DIR=dir -P rebuild.cmake
#
# Scripts that log each call start the generator and the compiler, so that the log of a build shows its steps. The
# folder names contain blanks, which dependency files must escape.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(work_dir "${WORK_DIR}/rebuild ${GENERATOR}")
set(robot_dir "${work_dir}/my robot")
set(build_dir "${work_dir}/build")
set(generated_dir "${build_dir}/generated")
set(log "${work_dir}/log")
set(tool "${work_dir}/robcogen")

function(write_script path text)
  file(WRITE "${path}" "#!/bin/sh\n${text}\n")
  file(CHMOD "${path}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()

function(set_up)
  file(REMOVE_RECURSE "${work_dir}")
  file(COPY ${SOURCE_DIR}/robots/hyl/hyl.kindsl ${SOURCE_DIR}/robots/hyl/hyl.dtdsl DESTINATION "${robot_dir}")
  # A robot that imports its leg, generated as text that nothing compiles.
  file(WRITE "${robot_dir}/walker.kindsl"
       "import \"leg.kindsl\"\nRobot Walker { RobotBase trunk { children { Leg left() Leg right() mirrored y } } }\n")
  file(WRITE "${robot_dir}/parts/leg.kindsl"
       "Part Leg { root thigh via hip link thigh { inertia_params { mass = 2.0 CoM = (0.0, 0.1, 0.2) Ix = 1.0 Iy = 1.0 "
       "Iz = 1.0 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children {} } r_joint hip { ref_frame { translation = (0.0, 0.0, 0.0) "
       "rotation = (PI/2.0, 0.0, 0.0) } } }\n")
  write_script("${tool}" "echo \"$1\" >> '${log}'; exec '${TOOL}' \"$@\"")
  # The last argument of the compiler is the source.
  write_script("${work_dir}/compile"
               "for source; do :; done; echo \"\${source##*/}\" >> '${log}'; exec ${COMPILER_LAUNCHER} \"$@\"")
  run(output ${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/rebuild -B "${build_dir}"
      -DCMAKE_CXX_COMPILER=${CXX_COMPILER} "-DCMAKE_CXX_COMPILER_LAUNCHER=${work_dir}/compile"
      "-DROBCOGEN_HOST_TOOL=${tool}" -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} "-DROBOT_DIR=${robot_dir}")
endfunction()

# Builds and compares the steps with the expected words: `generate`, and the names of the compiled sources.
function(expect_build event)
  file(WRITE "${log}" "")
  run(output ${CMAKE_COMMAND} --build "${build_dir}" --parallel 2)
  expect_done("${event}" ${ARGN})
endfunction()

function(expect_done event)
  file(STRINGS "${log}" done)
  set(expected ${ARGN})
  list(SORT done)
  list(SORT expected)
  expect_equal("${GENERATOR}, ${event}: the build's work" "${done}" "${expected}")
endfunction()

# File system clocks tick in steps of up to 10 ms, so a change right after a build could get the time of the build.
function(let_clock_tick)
  execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 0.05)
endfunction()

function(edit file from to)
  let_clock_tick()
  file(READ "${robot_dir}/${file}" text)
  string(FIND "${text}" "${from}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "${file} has no '${from}' to edit")
  endif()
  string(REPLACE "${from}" "${to}" text "${text}")
  file(WRITE "${robot_dir}/${file}" "${text}")
endfunction()

# Sets `result` to the paths, hashes and times of all generated files.
function(snapshot result)
  file(GLOB_RECURSE files RELATIVE "${generated_dir}" "${generated_dir}/hyl/*")
  set(entries "")
  foreach(file IN LISTS files)
    file(SHA256 "${generated_dir}/${file}" hash)
    file(TIMESTAMP "${generated_dir}/${file}" time "%s.%f")
    list(APPEND entries "${file} ${hash} ${time}")
  endforeach()
  set(${result} "${entries}" PARENT_SCOPE)
endfunction()

set_up()
expect_build("first build" generate generate inverse_dynamics.cpp jacobians.cpp parameters.cpp trigonometry.cpp)
expect_build("nothing changed")
expect_build("nothing changed, third build")

edit(hyl.kindsl "mass = 3.982" "mass = 4.982")
# parameters.cpp has the hash of the model.
expect_build("edited mass" generate inverse_dynamics.cpp parameters.cpp)
expect_build("nothing changed after an edit")

edit(hyl.dtdsl "base = fr_base, target = fr_foot" "base = fr_base, target = fr_foot base = fr_base, target = fr_lowerleg")
expect_build("edited desired transforms" generate jacobians.cpp)

snapshot(before)
edit(hyl.kindsl "// HyL:" "//   The robot HyL:")
edit(hyl.kindsl "    id = 1" "  id =\n 1")
expect_build("edited comment and layout" generate)
let_clock_tick()
file(TOUCH "${tool}")
expect_build("rebuilt tool with the same output" generate generate)
expect_build("nothing changed after a rebuilt tool")

# Only the robot that reads the import is generated again.
file(READ "${generated_dir}/walker.stamp" stamp)
edit(parts/leg.kindsl "mass = 2.0" "mass = 3.0")
expect_build("edited import" generate)
file(READ "${generated_dir}/walker.stamp" new_stamp)
if(stamp STREQUAL new_stamp)
  message(FATAL_ERROR "an edited import did not change the robot that reads it")
endif()
expect_build("nothing changed after an edited import")

edit(hyl.kindsl "upperleg via HFE" "upperleg via HFF")
file(WRITE "${log}" "")
run_failing(output ${CMAKE_COMMAND} --build "${build_dir}")
expect_done("error in the model" generate)
# Ninja's message begins with all outputs of the rule.
if(output MATCHES "FAILED: [^\n]*hyl/" OR (GENERATOR STREQUAL "Ninja" AND NOT output MATCHES "FAILED: [^\n]*hyl\\.stamp"))
  message(FATAL_ERROR "the message of the build system names other files than the stamp:\n${output}")
endif()
if(NOT output MATCHES "/my robot/hyl.kindsl:[0-9]+:[0-9]+: error: ")
  message(FATAL_ERROR "no message with file, line and column in\n${output}")
endif()
snapshot(after)
expect_equal("generated files after an error in the model" "${after}" "${before}")
edit(hyl.kindsl "upperleg via HFF" "upperleg via HFE")
expect_build("mended model" generate)
snapshot(after)
expect_equal("generated files of the mended model" "${after}" "${before}")

# Make has no rule for by-products, so the stamp must be removed, too.
file(REMOVE "${generated_dir}/hyl/kernel/jacobians.h")
if(GENERATOR STREQUAL "Unix Makefiles")
  file(REMOVE "${generated_dir}/hyl.stamp")
endif()
expect_build("removed header" generate jacobians.cpp)
