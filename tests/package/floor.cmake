# The oldest supported CMake is 3.22, so the functions use nothing newer. A robot is built as with 3.22, without file
# sets, and no script of the package uses another word that 3.22 does not know.
#
# cmake -D PREFIX=dir -D CXX_COMPILER=path -D SOURCE_DIR=dir -D WORK_DIR=dir -P floor.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

# Version 3 of the presets came with CMake 3.21.
set(later "PROPAGATE" "block[(]" "find_package.* GLOBAL" "FILE_SET" "VERIFY_" "[$]<PATH" "[$]<LIST" "[$]<BUILD_LOCAL" "[$]<COMPILE_ONLY"
    "HEADER_SETS" "REGISTRY_VIEW" "file[(]STRINGS.*REGEX.*LIMIT_" "CODEGEN$" "cmake_file_api" "cmake_pkg_config")
file(GLOB scripts ${SOURCE_DIR}/cmake/*.cmake ${SOURCE_DIR}/cmake/*.in ${SOURCE_DIR}/CMakeLists.txt ${SOURCE_DIR}/tool/CMakeLists.txt
     ${SOURCE_DIR}/runtime/CMakeLists.txt ${SOURCE_DIR}/robots/CMakeLists.txt ${SOURCE_DIR}/robots/*/CMakeLists.txt
     ${SOURCE_DIR}/bench/CMakeLists.txt)
foreach(script IN LISTS scripts)
  file(STRINGS ${script} lines)
  foreach(line IN LISTS lines)
    foreach(word IN LISTS later)
      if(line MATCHES "${word}" AND NOT line MATCHES "^ *#" AND NOT line MATCHES "target_sources.*PUBLIC FILE_SET|HEADER_SETS|headers FILE_SET")
        message(FATAL_ERROR "${script} uses ${word}, which CMake 3.22 does not know:\n${line}")
      endif()
    endforeach()
  endforeach()
endforeach()
file(READ ${SOURCE_DIR}/CMakePresets.json presets)
string(JSON version GET "${presets}" version)
expect_equal("version of the presets" "${version}" 3)

set(dir ${WORK_DIR}/floor)
file(REMOVE_RECURSE ${dir})
file(WRITE ${dir}/CMakeLists.txt "
  cmake_minimum_required(VERSION 3.22)
  project(old LANGUAGES C CXX)
  set(CMAKE_VERSION 3.22.1)
  macro(target_sources)
    if(\"\${ARGN}\" MATCHES FILE_SET)
      message(FATAL_ERROR \"CMake 3.22 has no file sets\")
    endif()
    _target_sources(\${ARGN})
  endmacro()
  find_package(robcogen REQUIRED)
  robcogen_add_robot(TARGET hyl MODEL ${SOURCE_DIR}/robots/hyl/hyl.kindsl LANGUAGES cpp c PROCESSORS baseline NO_TESTS NO_BENCH)
  add_executable(controller ${CMAKE_CURRENT_LIST_DIR}/consumers/main.cpp)
  target_link_libraries(controller PRIVATE hyl hyl_c)
  robcogen_install_robots(TARGETS hyl hyl_c)")
run(output ${CMAKE_COMMAND} -G Ninja -S ${dir} -B ${dir}/build -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_PREFIX_PATH=${PREFIX}
    -DCMAKE_INSTALL_PREFIX=${dir}/prefix)
run(output ${CMAKE_COMMAND} --build ${dir}/build --target controller --parallel 2)
run(output ${dir}/build/controller)
run(output ${CMAKE_COMMAND} --install ${dir}/build)
foreach(file include/hyl/hyl.h include/hyl/kernel/inverse_dynamics.h include/hyl_c/hyl_c.h lib/libhyl.a lib/libhyl_c.a
             lib/cmake/old/oldConfig.cmake)
  if(NOT EXISTS ${dir}/prefix/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
