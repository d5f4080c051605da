# Runs the examples of the guides: each CMake call configures in its own project; the C program compiles without a
# warning and runs; shell lines that begin with a prompt run in order.
#
# cmake -D PREFIX=dir -D TOOL=robcogen -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir -P snippets.cmake
# PREFIX is the prefix of the installed package.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(dir ${WORK_DIR}/snippets)
file(REMOVE_RECURSE ${dir})
set(robots ${SOURCE_DIR}/robots)

# Calls `use(text)` for each `language` block of a guide, and sets `count` to their number.
function(for_each_block guide language use count)
  file(READ ${SOURCE_DIR}/${guide} text)
  set(fence "\n```${language}\n")
  set(n 0)
  string(FIND "${text}" "${fence}" begin)
  while(NOT begin EQUAL -1)
    string(LENGTH "${fence}" length)
    math(EXPR begin "${begin} + ${length}")
    string(SUBSTRING "${text}" ${begin} -1 text)
    string(FIND "${text}" "\n```" end)
    string(SUBSTRING "${text}" 0 ${end} block)
    cmake_language(CALL ${use} "${block}")
    string(SUBSTRING "${text}" ${end} -1 text)
    math(EXPR n "${n} + 1")
    string(FIND "${text}" "${fence}" begin)
  endwhile()
  set(${count} ${n} PARENT_SCOPE)
endfunction()

# Writes a URDF: links of 1 kg from the base on, each with the type of the joint that carries it and the joint's name.
function(write_urdf file base)
  set(inertial "<inertial><mass value='1'/><inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial>")
  set(text "<robot name='robot'><link name='${base}'/>")
  set(parent ${base})
  foreach(item IN LISTS ARGN)
    string(REPLACE ":" ";" item ${item})
    list(POP_FRONT item link type joint)
    string(APPEND text "<link name='${link}'>${inertial}</link><joint name='${joint}' type='${type}'><parent link='${parent}'/>"
                       "<child link='${link}'/><origin xyz='0 0 0.3'/><axis xyz='0 1 0'/>"
                       "<limit lower='-1' upper='1' effort='9' velocity='9'/></joint>")
    set(parent ${link})
  endforeach()
  file(WRITE ${file} "${text}</robot>\n")
endfunction()

# Copies the documents that a snippet assumes; `leg` has parameters, and the contacts are those of the quadruped.
function(prepare folder)
  write_urdf(${folder}/arm.urdf base_link upper:revolute:shoulder forearm:revolute:elbow link3:revolute:wrist tool0:fixed:flange
             tool:fixed:grip)
  write_urdf(${folder}/panda.urdf panda_link0 panda_link1:revolute:panda_joint1 panda_finger:prismatic:panda_finger_joint1)
  file(WRITE ${folder}/g1.xml "<mujoco model='g1'><worldbody><body name='pelvis'>
    <body name='upper'><joint name='left_shoulder_pitch' axis='0 1 0'/><geom size='0.1' mass='1'/>
      <body name='lower' pos='0 0 0.3'><joint name='left_elbow' axis='0 1 0'/><geom size='0.1' mass='1'/></body></body>
    <body name='other'><joint name='right_elbow' axis='0 1 0'/><geom size='0.1' mass='1'/></body>
  </body></worldbody></mujoco>\n")
  foreach(robot hyl quadruped)
    file(GLOB documents ${robots}/${robot}/*.*dsl)
    file(COPY ${documents} DESTINATION ${folder})
  endforeach()
  run(output ${TOOL} convert ${robots}/quadruped/quadruped.kindsl ${folder}/a1.urdf)
  file(COPY_FILE ${robots}/hyl_parametric/hyl_parametric.kindsl ${folder}/leg.kindsl)
  file(COPY_FILE ${robots}/euler/euler.motdsl ${folder}/crane.motdsl)
  file(COPY_FILE ${robots}/design/quadruped_parametric.kindsl ${folder}/quadruped_parametric.kindsl)
  file(COPY_FILE ${robots}/design/quadruped_parametric.dtdsl ${folder}/quadruped_parametric.dtdsl)
endfunction()

function(configure_block block)
  string(MD5 name "${block}")
  set(folder ${dir}/${name})
  file(MAKE_DIRECTORY ${folder})
  prepare(${folder})
  file(CREATE_LINK ${SOURCE_DIR} ${folder}/robcogen SYMBOLIC)
  set(before "cmake_minimum_required(VERSION 3.22...3.25)\nproject(controllers VERSION 1.2.0 LANGUAGES C CXX)\n")
  if(NOT block MATCHES "find_package\\(robcogen|add_subdirectory\\(robcogen|FetchContent")
    string(APPEND before "find_package(robcogen REQUIRED)\n")
  endif()
  if(block MATCHES "INCLUDES DESTINATION") # the snippet is for this version
    string(APPEND before "set(CMAKE_VERSION 3.22.1)\n")
  endif()
  if(NOT block MATCHES "robcogen_add_robot|robcogen_add_transforms" AND block MATCHES "hyl")
    string(APPEND before "robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)\n")
  endif()
  file(WRITE ${folder}/main.cpp "int main() {}\n")
  string(APPEND before "add_executable(my_controller main.cpp)\n")
  # An ellipsis stands for further arguments.
  string(REPLACE " …)" ")" block "${block}")
  file(WRITE ${folder}/CMakeLists.txt "${before}${block}\n")
  run(output ${CMAKE_COMMAND} -G Ninja -S ${folder} -B ${folder}/build -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
      -DROBCOGEN_SOURCE_DIR=${SOURCE_DIR} -DROBCOGEN_HOST_TOOL=${TOOL})
  # Generates the code that the calls ask for.
  file(GLOB made LIST_DIRECTORIES true ${folder}/build/robcogen.gen/*)
  foreach(robot IN LISTS made)
    cmake_path(GET robot FILENAME target)
    run(output ${CMAKE_COMMAND} --build ${folder}/build --target ${target}_codegen)
  endforeach()
endfunction()

function(run_c block)
  file(WRITE ${dir}/c/main.c "${block}\n")
  run(output ${TOOL} generate ${robots}/hyl/hyl.kindsl --name hyl --language c -o ${dir}/c --algorithms inverse_dynamics joint_space_inertia)
  file(GLOB sources ${dir}/c/c/hyl_c/*.c)
  list(FILTER sources EXCLUDE REGEX "_f[.]c$|casadi")
  run(output cc -std=c99 -pedantic -Wall -Wextra -Werror -I${dir}/c/c ${dir}/c/main.c ${sources} -lm -o ${dir}/c/main)
  run(output ${dir}/c/main)
  # The program computes with the moon's gravity; the interpreter must give the same force.
  file(WRITE ${dir}/c/state.json "{\"q\": [0.64, -0.65, 1.34], \"qd\": [0.0, 0.5, -1.0], \"qdd\": [1.0, 0.5, 2.0], \"gravity\": [0.0, 0.0, -1.62]}")
  run(expected bash -c "${TOOL} eval --quiet ${robots}/hyl/hyl.kindsl inverse_dynamics < ${dir}/c/state.json")
  string(JSON slide GET "${expected}" tau 0)
  string(SUBSTRING "${slide}" 0 6 slide)
  expect_words("the program in C" "${output}" "SLIDE ${slide}")
endfunction()

set(shell ${dir}/shell)
file(MAKE_DIRECTORY ${shell}/bin)
file(CREATE_LINK ${TOOL} ${shell}/bin/robcogen SYMBOLIC)
prepare(${shell})
file(WRITE ${shell}/pendulum.kindsl "Robot Pendulum {
  RobotBase base { children { bob via swing } }
  link bob { id = 1  inertia_params { mass = 1.0 CoM = (0.5, 0.0, 0.0) Ix = 0.0 Iy = 0.3 Iz = 0.3 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children {} }
  r_joint swing { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (PI / 2.0, 0.0, 0.0) } }
}")
file(WRITE ${shell}/states.jsonl "{\"q\": [0.1, 0.2, 0.3]}\n{\"q\": [0, 0, 0]}\n")

function(run_shell block)
  string(REGEX REPLACE "(^|\n)[$] " "\\1" lines "${block}")
  file(WRITE ${shell}/lines.sh "PATH=${shell}/bin:$PATH\n${lines}\n")
  run(output ${CMAKE_COMMAND} -E chdir ${shell} bash -e -o pipefail ${shell}/lines.sh)
endfunction()

foreach(guide README.md cmake/README.md runtime/CONTACTS.md robots/design/README.md)
  for_each_block(${guide} cmake configure_block count)
  if(count EQUAL 0)
    message(FATAL_ERROR "${guide} has no call of CMake")
  endif()
endforeach()
for_each_block(runtime/LANGUAGES.md c run_c count)
expect_equal("programs in C" ${count} 1)
foreach(guide tool/README.md tool/view/README.md)
  for_each_block(${guide} sh run_shell count)
  if(count EQUAL 0)
    message(FATAL_ERROR "${guide} has no line of the shell")
  endif()
endforeach()
file(STRINGS ${shell}/jacobians.jsonl lines)
list(LENGTH lines count)
expect_equal("lines of Jacobians" ${count} 2)
foreach(picture quadruped.html quadruped.svg arm.svg hyl.svg)
  if(NOT EXISTS ${shell}/${picture})
    message(FATAL_ERROR "${picture} is not drawn")
  endif()
endforeach()
