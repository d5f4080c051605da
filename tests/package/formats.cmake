# The tool reads files in other formats and under other names; its messages about conversions.
#
# cmake -D TOOL=robcogen -D WORK_DIR=dir -P formats.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(work_dir ${WORK_DIR}/formats)
file(REMOVE_RECURSE ${work_dir})

# The hand is declared before the arm that carries it.
set(body "<inertial><origin xyz='0.1 0 0'/><mass value='1'/>\
<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>")
set(urdf
    "<?xml version='1.0'?>
<!-- A robot in any file. -->
<robot name='arm'>
  <link name='base'>${body}</link><link name='hand'>${body}</link><link name='upper'>${body}</link>
  <joint name='wrist' type='continuous'><parent link='upper'/><child link='hand'/><axis xyz='0 0 1'/></joint>
  <joint name='shoulder' type='continuous'><parent link='base'/><child link='upper'/><axis xyz='0 0 1'/></joint>
</robot>")
foreach(name arm.xml arm arm.urdf arm.kindsl)
  file(WRITE ${work_dir}/${name} "${urdf}")
  run(output ${TOOL} check --floating-base ${work_dir}/${name})
  expect_equal("${name}: messages" "${output}" "")
endforeach()

# From standard input to a robot document in which parents come first.
execute_process(
  COMMAND ${TOOL} convert - ${work_dir}/converted.kindsl
  INPUT_FILE ${work_dir}/arm.xml
  ERROR_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
expect_words("order of q" "${output}" "which changes the order of q to shoulder, wrist [joint-order]")
run(output ${TOOL} check ${work_dir}/converted.kindsl)
expect_equal("what was converted: messages" "${output}" "")
file(READ ${work_dir}/converted.kindsl document)
foreach(earlier_and_later "link upper;link hand" "id = 1;id = 2" "r_joint shoulder;r_joint wrist")
  list(GET earlier_and_later 0 earlier)
  list(GET earlier_and_later 1 later)
  string(FIND "${document}" "${earlier}" first)
  string(FIND "${document}" "${later}" second)
  if(first EQUAL -1 OR NOT first LESS second)
    message("${document}")
    message(FATAL_ERROR "'${earlier}' must stand before '${later}'")
  endif()
endforeach()

# An unknown format gives one message, whatever the name of the file.
file(WRITE ${work_dir}/arm.dae "<COLLADA/>")
file(WRITE ${work_dir}/arm.motdsl "${urdf}")
file(WRITE ${work_dir}/arm.json "{ \"robot\": \"arm\" }")
foreach(name arm.dae arm.motdsl arm.json)
  run_failing(output ${TOOL} check ${work_dir}/${name})
  string(REGEX MATCHALL "error: " errors "${output}")
  expect_equal("${name}: errors" "${errors}" "error: ")
  expect_words("${name}" "${output}" "[other-format]")
endforeach()

# Impossible mass properties are written unchanged, with a warning that readers will refuse them.
string(REPLACE "Ix = 1.0" "Ix = -1.0" document "${document}")
file(WRITE ${work_dir}/implausible.kindsl "${document}")
run(output ${TOOL} convert ${work_dir}/implausible.kindsl ${work_dir}/implausible.urdf)
expect_words("implausible" "${output}" "[implausible-urdf]")
run(output ${TOOL} check --allow-implausible ${work_dir}/implausible.urdf)

# A MuJoCo model under any name: its included file is read and listed, and the converted robot document gives the same
# operations.
set(mjcf "<mujoco model='crane'>
  <include file='parts/jib.inc'/>
  <worldbody><body name='mast'><joint name='swing' damping='0.5' range='-90 90'/>
    <inertial pos='0 0.1 0' mass='2' diaginertia='0.1 0.1 0.1'/></body></worldbody>
</mujoco>")
file(WRITE ${work_dir}/parts/jib.inc "<mujocoinclude><option gravity='0 0 -9.81'/></mujocoinclude>")
foreach(name crane.xml crane crane.urdf crane.kindsl)
  file(WRITE ${work_dir}/${name} "${mjcf}")
  run(output ${TOOL} check ${work_dir}/${name})
  expect_equal("${name}: messages" "${output}" "")
endforeach()
run(output ${TOOL} generate ${work_dir}/crane.xml -o ${work_dir}/crane_of_mjcf --name crane --depfile
    ${work_dir}/crane.d --stamp ${work_dir}/crane.stamp)
file(READ ${work_dir}/crane.d dependencies)
expect_words("dependencies" "${dependencies}" "parts/jib.inc")
run(output ${TOOL} convert ${work_dir}/crane.xml ${work_dir}/crane_again.kindsl)
expect_equal("convert: messages" "${output}" "")
foreach(model crane.xml crane_again.kindsl)
  run(output ${TOOL} ops --json ${work_dir}/${model})
  string(REGEX REPLACE "\"model\": [^\n]*" "" ${model}_ops "${output}")
endforeach()
expect_equal("operations after convert" "${crane_again.kindsl_ops}" "${crane.xml_ops}")

# An SDF under any name: the model that it includes is read and listed, and the converted robot document gives the same
# operations.
set(arm_of_sdf "<inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>")
file(WRITE ${work_dir}/hand/model.sdf
     "<sdf version='1.9'><model name='hand'><link name='palm'>${arm_of_sdf}</link></model></sdf>")
foreach(name holder.sdf holder.world holder holder.kindsl)
  file(WRITE ${work_dir}/${name}
       "<sdf version='1.9'><model name='holder'><link name='base'>${arm_of_sdf}</link>
<include><uri>model://hand</uri><pose>0 0 1 0 0 0</pose></include>
<joint name='fix' type='fixed'><parent>world</parent><child>base</child></joint>
<joint name='wrist' type='revolute'><parent>base</parent><child>hand::palm</child></joint></model></sdf>")
  run(output ${TOOL} check ${work_dir}/${name})
  expect_words("${name}: messages" "${output}" "link 'hand::palm' becomes 'hand__palm' [names-changed]")
endforeach()
run(output ${TOOL} generate ${work_dir}/holder.sdf -o ${work_dir}/holder_of_sdf --name holder --depfile
    ${work_dir}/holder.d --stamp ${work_dir}/holder.stamp)
file(READ ${work_dir}/holder.d dependencies)
expect_words("dependencies" "${dependencies}" "hand/model.sdf")
run(output ${TOOL} convert ${work_dir}/holder.sdf ${work_dir}/holder_again.kindsl)
foreach(model holder.sdf holder_again.kindsl)
  execute_process(
    COMMAND ${TOOL} ops --json ${work_dir}/${model}
    OUTPUT_VARIABLE output
    ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "\"model\": [^\n]*" "" ${model}_ops "${output}")
endforeach()
expect_equal("operations after convert" "${holder_again.kindsl_ops}" "${holder.sdf_ops}")
run_failing(output ${TOOL} convert ${work_dir}/crane.xml ${work_dir}/crane.sdf)
expect_words("convert to SDF" "${output}" "the languages are .kindsl, .urdf, .motdsl and .ctdsl")
run_failing(output ${TOOL} check --passive-forces ${work_dir}/holder.sdf)
expect_words("options of URDF with SDF" "${output}" "states these properties itself")
run(output ${TOOL} check --snap-angles --free-mimic-joints --robot holder ${work_dir}/holder.sdf)
run_failing(output ${TOOL} ops --floating-base ${work_dir}/crane.xml)
expect_words("options of URDF" "${output}" "states these properties itself")
run_failing(output ${TOOL} print ${work_dir}/crane.xml)
expect_words("print" "${output}" "'robcogen convert' turns it into one")
