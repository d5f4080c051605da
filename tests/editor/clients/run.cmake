# Runs a session of a real editor with the language server; the client's script prints which checks hold and which fail.
#
# cmake -D CLIENT=neovim|emacs -D EDITOR=program -D REQUIRED=bool -D TOOL=robcogen -D SOURCE_DIR=dir -D FOLDER=dir -P run.cmake
cmake_minimum_required(VERSION 3.22...3.25)

if(NOT EDITOR)
  if(REQUIRED)
    message(FATAL_ERROR "${CLIENT} is not installed")
  endif()
  message("skipped: ${CLIENT} is not installed")
  return()
endif()

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/home)
# The program is on the path under its own name, as the editors' pages assume.
file(MAKE_DIRECTORY ${FOLDER}/bin)
file(CREATE_LINK ${TOOL} ${FOLDER}/bin/robcogen SYMBOLIC)
file(WRITE ${FOLDER}/arm.kindsl
"Robot Arm {
    // 🤖 the arm
    RobotBase base { /* 🤖 */ children { uppor via shoulder } }
    link upper { id = 1 inertia_params { mass = 2.0 CoM = (0.5, 0.0, 0.0)
            Ix = 0.1  Iy = 0.8  Iz = 0.9  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0 } children {} }
    r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
}
")
file(WRITE ${FOLDER}/arm.dtdsl "Robot Arm\nFrames { fr_upper }\nTransforms { fr_base -> fr_upper }\n")

# A folder of imports that the client names in its settings.
file(WRITE ${FOLDER}/parts/leg.kindsl
"Part Leg {
    root hip via HAA
    link hip { children {} }
    r_joint HAA { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }
}
")
file(WRITE ${FOLDER}/biped.kindsl "import \"leg.kindsl\"\nRobot Biped { RobotBase trunk { children { Leg left() } } }\n")

set(scripts ${SOURCE_DIR}/tests/editor/clients)
set(result ${FOLDER}/result)
if(CLIENT STREQUAL "neovim")
  set(command ${EDITOR} --headless -u NONE -c "luafile ${scripts}/neovim.lua")
else()
  set(command ${EDITOR} --batch -Q -l ${scripts}/emacs.el)
endif()
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env HOME=${FOLDER}/home XDG_CONFIG_HOME=${FOLDER}/home XDG_STATE_HOME=${FOLDER}/home
          XDG_DATA_HOME=${FOLDER}/home XDG_CACHE_HOME=${FOLDER}/home LC_ALL=C.UTF-8 ROBCOGEN=${TOOL} FOLDER=${FOLDER} RESULT=${result}
          PLUGIN=${SOURCE_DIR}/tool/editors/${CLIENT} PATH=${FOLDER}/bin:$ENV{PATH} ${command}
  TIMEOUT 100
  OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT EXISTS ${result})
  message(FATAL_ERROR "${CLIENT} wrote no result\n${output}")
endif()
file(READ ${result} checks)
string(REGEX MATCHALL "(^|\n)ok " held "${checks}")
list(LENGTH held count)
if(checks MATCHES "FAILED" OR count LESS 8)
  message(FATAL_ERROR "${checks}\n${output}")
endif()
message("${checks}")
