# The source archive: it contains exactly the files of the repository, and the unpacked sources build.
#
# cmake -D BUILD_DIR=dir -D WORK_DIR=dir -D SOURCE_DIR=dir -D TOOL=robcogen -D CXX_COMPILER=path -D VERSION=1.0.0
#       [-D WHOLE=ON] -P source.cmake
# WHOLE: the generator is built from the archive; otherwise TOOL is the generator.
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(dir ${WORK_DIR}/source)
if(WHOLE)
  string(APPEND dir _whole)
endif()
file(REMOVE_RECURSE ${dir})
run(output ${CMAKE_CPACK_COMMAND} --config ${BUILD_DIR}/CPackSourceConfig.cmake -B ${dir})
set(archive ${dir}/robcogen-${VERSION}.tar.gz)
run(output ${CMAKE_COMMAND} -E chdir ${dir} ${CMAKE_COMMAND} -E tar xzf ${archive})
set(unpacked ${dir}/robcogen-${VERSION})

# Files that git tracks, and new files that are not ignored.
find_program(git git)
if(git AND EXISTS ${SOURCE_DIR}/.git)
  run(expected ${git} -C ${SOURCE_DIR} -c core.quotePath=off ls-files --cached --others --exclude-standard)
  string(REGEX REPLACE "\n" ";" expected "${expected}")
  list(REMOVE_ITEM expected "")
  foreach(file IN LISTS expected)
    if(EXISTS ${SOURCE_DIR}/${file} AND NOT EXISTS ${unpacked}/${file})
      message(FATAL_ERROR "the archive has no ${file}")
    endif()
  endforeach()
  file(GLOB_RECURSE files RELATIVE ${unpacked} ${unpacked}/* ${unpacked}/.*)
  list(REMOVE_ITEM files ${expected})
  expect_equal("files of the archive that the repository has not" "${files}" "")
endif()

set(tool -DROBCOGEN_HOST_TOOL=${TOOL})
if(WHOLE)
  # The test checks that the generator compiles, not how fast it runs.
  set(tool -DCMAKE_CXX_FLAGS_RELEASE=-O0)
endif()
run(output ${CMAKE_COMMAND} -S ${unpacked} -B ${unpacked}/build/here -G Ninja -DBUILD_TESTING=OFF -DROBCOGEN_QUICK_BUILD=ON
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX_COMPILER} ${tool})
run(output ${CMAKE_COMMAND} --build ${unpacked}/build/here --target hyl_print_dynamics --parallel 2)
run(output ${unpacked}/build/here/robots/hyl/hyl_print_dynamics)
expect_words("program" "${output}" "tau")
if(WHOLE)
  run(output ${CMAKE_COMMAND} --install ${unpacked}/build/here --prefix ${dir}/prefix)
  run(output ${dir}/prefix/bin/robcogen --version)
  expect_words("version" "${output}" "robcogen ${VERSION}")
endif()
file(REMOVE_RECURSE ${unpacked})
