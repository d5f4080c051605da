# The Debian package: its dependencies; installation by dpkg; robots built from its files with CMake, pkg-config and
# Python; removal.
# cmake -D BUILD_DIR=dir -D CONFIG=name -D WORK_DIR=dir -D CXX_COMPILER=path -D SOURCE_DIR=dir -P debian.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
foreach(program dpkg dpkg-deb dpkg-shlibdeps pkg-config)
  find_program(found_${program} ${program})
  if(NOT found_${program})
    message(STATUS "skipped: there is no ${program}")
    return()
  endif()
endforeach()

set(dir ${WORK_DIR}/debian)
file(REMOVE_RECURSE ${dir})
run(output ${CMAKE_COMMAND} -DBUILD_DIR=${BUILD_DIR} -DCONFIG=${CONFIG} -DOUTPUT=${dir} -P ${SOURCE_DIR}/cmake/debian_package.cmake)
file(GLOB package ${dir}/robcogen_*.deb)
run(fields dpkg-deb --field ${package})
expect_words("fields" "${fields}" "Package: robcogen")
expect_words("fields" "${fields}" "libeigen3-dev")
expect_words("fields" "${fields}" "libc6")
expect_words("fields" "${fields}" "Maintainer: RobCoGen developers <robcogen@example.org>")

# The package is installed into its own dpkg database, whose root is this folder.
set(root ${dir}/root)
file(MAKE_DIRECTORY ${root}/var/lib/dpkg/info ${root}/var/lib/dpkg/updates)
file(TOUCH ${root}/var/lib/dpkg/status ${root}/var/lib/dpkg/available)
set(dpkg dpkg --root=${root} --force-not-root --force-depends --force-bad-path --force-script-chrootless --log=/dev/null)
run(output ${dpkg} --install ${package})
run(output ${dpkg} --verify robcogen)
expect_equal("files that dpkg finds changed" "${output}" "")
run(status ${dpkg} --status robcogen)
expect_words("status" "${status}" "Status: install ok installed")
set(prefix ${root}/usr)
foreach(file bin/robcogen lib/cmake/robcogen/robcogenConfig.cmake share/doc/robcogen/copyright share/doc/robcogen/changelog.gz
             share/doc/robcogen/README.md share/doc/robcogen/runtime/README.md share/robcogen/python/robcogen/__init__.py
             share/man/man1/robcogen.1.gz share/bash-completion/completions/robcogen share/zsh/vendor-completions/_robcogen
             share/fish/vendor_completions.d/robcogen.fish share/robcogen/editors/neovim/plugin/robcogen.lua
             share/robcogen/editors/vscode/package.json)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "the package has no ${file}")
  endif()
endforeach()
run(output bash -c ". ${prefix}/share/bash-completion/completions/robcogen && COMP_WORDS=(robcogen gen) && COMP_CWORD=1 && _robcogen && echo $COMPREPLY")
expect_words("completion" "${output}" "generate")
run(page zcat ${prefix}/share/man/man1/robcogen.1.gz)
expect_words("manual page" "${page}" ".TH ROBCOGEN 1 \"\" \"robcogen ${VERSION}\"")

# Build with CMake.
run(output ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumers/find_package -B ${dir}/by_cmake -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DROBOTS_DIR=${prefix}/share/robcogen/robots -DBUILD_TESTING=OFF)
run(output ${CMAKE_COMMAND} --build ${dir}/by_cmake --target controller --parallel 2)
run(output ${dir}/by_cmake/controller)

# Build with pkg-config, whose variables are relative to the installed tree.
set(ENV{PKG_CONFIG_PATH} ${prefix}/share/pkgconfig)
run(tool pkg-config --variable=tool robcogen)
string(STRIP "${tool}" tool)
run(flags pkg-config --cflags robcogen)
separate_arguments(flags UNIX_COMMAND "${flags}")
set(robot ${prefix}/share/robcogen/robots/hyl/hyl.kindsl)
run(output ${tool} generate ${robot} --name hyl --algorithms inverse_dynamics -o ${dir}/generated)
file(WRITE ${dir}/main.cpp
     "#include <hyl/hyl.h>\nint main() { return hyl::inverse_dynamics({0, 0, 0}, {0, 0, 0}, {0, 0, 0})[0] > 73 ? 0 : 1; }\n")
run(output ${CXX_COMPILER} -std=c++17 ${flags} -I${dir}/generated ${dir}/main.cpp ${dir}/generated/hyl/inverse_dynamics.cpp
    ${dir}/generated/hyl/trigonometry.cpp -o ${dir}/main)
run(output ${dir}/main)

# Build with Python, if its headers are installed.
execute_process(
  COMMAND /usr/bin/python3 -c "import sysconfig, os; assert os.path.isfile(sysconfig.get_paths()['include'] + '/Python.h')"
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
if(status EQUAL 0)
  set(ENV{PYTHONPATH} ${prefix}/share/robcogen/python)
  set(ENV{PYTHONDONTWRITEBYTECODE} 1)
  set(ENV{ROBCOGEN_TOOL} ${tool})
  set(ENV{ROBCOGEN_CACHE} ${dir}/cache)
  run(output /usr/bin/python3 -m robcogen ${robot} --algorithms inverse_dynamics -o ${dir}/module)
  expect_words("module" "${output}" "hyl.abi3.so")
  run(output ${CMAKE_COMMAND} -E chdir ${dir}/module /usr/bin/python3 -c "print(list(__import__('hyl').inverse_dynamics([0]*3, [0]*3, [0]*3)))")
  expect_words("joint forces" "${output}" "[73.58")
endif()

# Removal leaves nothing.
run(output ${dpkg} --purge robcogen)
if(EXISTS ${prefix}/bin/robcogen OR EXISTS ${prefix}/share/robcogen)
  message(FATAL_ERROR "dpkg --purge leaves files of the package")
endif()
