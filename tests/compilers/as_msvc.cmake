# Generated code without any construct of gcc: clang compiles it with the macros of MSVC, for which gcc's are errors. Not MSVC: no
# message of that compiler is known here.
# cmake -D TOOL=robcogen -D CLANGXX=path -D SOURCE_DIR=dir -D EIGEN_DIR=dir -D FOLDER=dir -P as_msvc.cmake
cmake_minimum_required(VERSION 3.22...3.25)
file(REMOVE_RECURSE ${FOLDER})
foreach(robot hyl quadruped)
  execute_process(
    COMMAND ${TOOL} generate ${SOURCE_DIR}/robots/${robot}/${robot}.kindsl -o ${FOLDER} --name ${robot} --batch
    COMMAND_ERROR_IS_FATAL ANY ERROR_QUIET)
  file(GLOB sources RELATIVE ${FOLDER} ${FOLDER}/${robot}/*.cpp)
  list(TRANSFORM sources REPLACE "(.+)" "#include \"\\1\"")
  list(JOIN sources "\n" text)
  file(WRITE ${FOLDER}/${robot}.cpp "${text}\n")
  execute_process(
    COMMAND ${CLANGXX} -std=c++17 -fsyntax-only -pedantic-errors -Wno-everything -Werror=gnu -include
            ${CMAKE_CURRENT_LIST_DIR}/msvc/as_msvc.h -isystem ${EIGEN_DIR} -I${SOURCE_DIR}/runtime/include -I${FOLDER}
            ${FOLDER}/${robot}.cpp COMMAND_ERROR_IS_FATAL ANY)
endforeach()
